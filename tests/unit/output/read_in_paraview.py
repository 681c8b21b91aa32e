#!/usr/bin/python3
"""Opens example wall and fluid files with ParaView's own XDMF readers and checks what they show.

usage: read_in_paraview.py WRITE_EXAMPLE_FIELDS
Exit code 77 (skipped) where ParaView's Python package is absent (Debian: python3-paraview).
"""
import os
import subprocess
import sys
import tempfile

try:
    from paraview import simple
    from paraview import servermanager
except ImportError:
    print("skipped: python3-paraview is not installed")
    sys.exit(77)

READERS = {
    "Xdmf2": lambda path: simple.XDMFReader(FileNames=[path]),
    "Xdmf3": lambda path: simple.Xdmf3ReaderS(FileName=[path]),
    "Xdmf3 top level": lambda path: simple.Xdmf3ReaderT(FileName=[path]),
    "by file name": simple.OpenDataFile,
}
TIMES = [0.0, 0.5, 1.0]
failures = []


def check(what, found, expected, tolerance=1e-4):
    if isinstance(expected, list) and isinstance(expected[0], float):
        same = len(found) == len(expected) and all(
            abs(a - b) <= tolerance for a, b in zip(found, expected))
    elif isinstance(expected, float):
        same = abs(found - expected) <= tolerance
    else:
        same = found == expected
    print(f"{'ok    ' if same else 'FAILED'} {what}: {found}" + ("" if same else f", expected {expected}"))
    if not same:
        failures.append(what)


def open_at(reader, path, time):
    """The reader's only grid at a time, and the times it knows."""
    source = READERS[reader](path)
    source.UpdatePipelineInformation()
    times = list(source.TimestepValues)
    source.UpdatePipeline(time)
    data = servermanager.Fetch(source)
    while data.IsA("vtkCompositeDataSet"):
        data = data.GetBlock(0)
    return data, times


def names(arrays):
    return sorted(arrays.GetArrayName(n) for n in range(arrays.GetNumberOfArrays()))


def check_wall(reader, path):
    wall, times = open_at(reader, path, 0.5)
    check(f"{reader} wall times", times, TIMES)
    check_wall_data(reader, wall)


def check_wall_data(reader, wall):
    """The wall at t = 0.5."""
    check(f"{reader} wall points", wall.GetNumberOfPoints(), 4)
    check(f"{reader} wall triangles", wall.GetNumberOfCells(), 4)
    check(f"{reader} wall point arrays", names(wall.GetPointData()),
          ["displacement", "transmural_pressure"])
    check(f"{reader} wall cell arrays", names(wall.GetCellData()), ["tension1"])
    check(f"{reader} wall point 1 at t = 0.5", list(wall.GetPoint(1)), [1.5, 1.0, 1.5])
    check(f"{reader} wall triangle 2", [wall.GetCell(2).GetPointId(n) for n in range(3)], [1, 2, 3])
    check(f"{reader} displacement of point 3",
          list(wall.GetPointData().GetArray("displacement").GetTuple(3)), [0.5, 1.0, 1.5])
    check(f"{reader} pressure at point 3",
          wall.GetPointData().GetArray("transmural_pressure").GetValue(3), 30.0)
    check(f"{reader} tension of triangle 3", wall.GetCellData().GetArray("tension1").GetValue(3), 3.5)


def check_fluid(reader, path):
    fluid, times = open_at(reader, path, 1.0)
    check(f"{reader} fluid times", times, TIMES)
    check_fluid_data(reader, fluid)


def check_fluid_data(reader, fluid):
    """The fluid at t = 1."""
    check(f"{reader} fluid cells", fluid.GetNumberOfCells(), 6 * 4 * 5)
    check(f"{reader} fluid is an image", fluid.IsA("vtkImageData"), 1)
    check(f"{reader} fluid bounds: x along the tube", list(fluid.GetBounds()),
          [0.0, 3.0, -1.0, 0.0, -2.0, 1.75])
    check(f"{reader} fluid cell arrays", names(fluid.GetCellData()), ["pressure", "velocity"])
    pressure = fluid.GetCellData().GetArray("pressure")
    velocity = fluid.GetCellData().GetArray("velocity")
    worst = 0.0
    for n in range(fluid.GetNumberOfCells()):
        b = fluid.GetCell(n).GetBounds()
        x, y, z = (b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2
        worst = max(worst, abs(pressure.GetValue(n) - (1.0 + x + 10 * y + 100 * z)),
                    *(abs(a - c) for a, c in zip(velocity.GetTuple(n), (x, y, z))))
    check(f"{reader} every cell's value belongs to its position (largest error)", worst, 0.0)


def check_exported(directory):
    """What `starling export` writes."""
    for name, check_data, time, unit in (("wall.vtp", check_wall_data, 0.5, "tension1 [rho U_c^2 R_0]"),
                                         ("fluid.vti", check_fluid_data, 1.0, "velocity [U_c]")):
        source = simple.OpenDataFile(os.path.join(directory, name))
        source.UpdatePipeline()
        data = servermanager.Fetch(source)
        check_data(name, data)
        field = data.GetFieldData()
        check(f"{name} time", field.GetArray("TimeValue").GetValue(0), time)
        units = field.GetAbstractArray("units").GetValue(0)
        check(f"{name} units", unit in units and units.startswith("t [R_0/U_c]"), True)


def main():
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run([sys.argv[1], directory], check=True)
        for reader in READERS:
            check_wall(reader, os.path.join(directory, "wall.xdmf"))
            check_fluid(reader, os.path.join(directory, "fluid.xdmf"))
        check_exported(directory)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
