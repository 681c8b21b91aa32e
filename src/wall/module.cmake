starling_module(wall
  SOURCES materials.cpp wall_mesh.cpp tube.cpp geometry.cpp cross_section.cpp element_forces.cpp elastic_force.cpp membrane_viscosity.cpp curvature.cpp
          bending_force.cpp smoothing.cpp perturbation.cpp mesh_filter.cpp high_pass.cpp rigid_support.cpp lumen.cpp contact.cpp
          tissue.cpp
  DEPENDS starling_core)
