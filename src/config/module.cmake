starling_module(config SOURCES scaling.cpp DEPENDS starling_core)
