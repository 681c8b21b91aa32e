starling_test(wall_unit unit SOURCES unit/wall/materials_test.cpp DEPENDS starling_wall)
