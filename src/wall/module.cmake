starling_module(wall SOURCES materials.cpp DEPENDS starling_core)
