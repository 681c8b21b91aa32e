starling_module(grid SOURCES grid.cpp boundary.cpp DEPENDS starling_core)
