#!/usr/bin/env python3
"""Reads the frames of a run with VTK's own reader, checks them, and renders one as a picture.

    .ci/vtk_frames.py RUN/frames PICTURE.png
"""
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory of what renders


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetErrorCode() != 0:
        sys.exit(f"{path}: VTK cannot read it")
    return reader.GetOutput()


def main(folder, picture):
    (collection,) = Path(folder).glob("*.pvd")
    entries = [e for e in xml.parse(collection).getroot().iter("DataSet") if e.get("part") == "0"]
    times = [float(e.get("timestep")) for e in entries]
    if len(times) < 2 or times != sorted(set(times)):
        sys.exit(f"{collection}: times do not rise")
    walls = read(next(Path(folder).glob("*_walls.vtp")))
    outlines = read(next(Path(folder).glob("*_outlines.vtp")))
    if outlines.GetNumberOfLines() < 2 or outlines.GetNumberOfPolys() == 0:
        sys.exit("the outlines are no bed and barriers")
    numbers = vtk_to_numpy(outlines.GetCellData().GetArray("barrier"))
    if sorted(set(numbers[numbers > 0])) != list(range(1, numbers.max() + 1)):
        sys.exit(f"barriers numbered {numbers}")
    gauges = read(next(Path(folder).glob("*_gauges.vtp")))
    if gauges.GetNumberOfLines() < 4 or gauges.GetCellData().GetArray("gauge") is None:
        sys.exit(f"{gauges.GetNumberOfLines()} gauges")
    released = read(Path(folder) / entries[0].get("file")).GetNumberOfPoints()
    for entry in entries:
        frame = read(Path(folder) / entry.get("file"))
        points = frame.GetNumberOfPoints()
        if points == 0 or points > released or frame.GetNumberOfVerts() != points:
            sys.exit(f"{entry.get('file')}: {points} points, {frame.GetNumberOfVerts()} cells")
        density = vtk_to_numpy(frame.GetPointData().GetArray("density_kg_m3"))
        if not (density > 500).all():
            sys.exit(f"{entry.get('file')}: densities from {density.min()}")
        velocity = frame.GetPointData().GetArray("velocity_m_s")
        if velocity.GetNumberOfComponents() != 3 or velocity.GetNumberOfTuples() != points:
            sys.exit(f"{entry.get('file')}: velocities of another shape")
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    middle = read(Path(folder) / entries[len(entries) // 2].get("file"))
    parts = ((middle, None), (walls, (0.6, 0.6, 0.6)), (outlines, (0.2, 0.2, 0.2)), (gauges, (0, 0.4, 0.7)))
    for data, color in parts:
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        actor = vtkActor()
        if color is None:
            data.GetPointData().SetActiveScalars("pressure_pa")
            mapper.SetScalarRange(0, 1500)
        else:
            mapper.ScalarVisibilityOff()
            actor.GetProperty().SetColor(*color)
        actor.SetMapper(mapper)
        actor.GetProperty().SetPointSize(3)
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    left, right, _, _, _, _ = middle.GetBounds()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint((left + right) / 2, 0.15, 0)
    camera.SetPosition((left + right) / 2, 0.15, 1)
    camera.SetParallelScale(0.22 * (right - left))
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(1000, 400)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    print(f"{len(times)} frames read by VTK, from {times[0]:g} to {times[-1]:g} s; {picture}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
