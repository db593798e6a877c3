# SPDX-License-Identifier: GPL-3.0-or-later
"""Blind, exactly calibrated watermarks for 3D meshes.

    import wm3d
    key = wm3d.Key.generate("City Museum")
    mesh = wm3d.read("scan.ply")
    marked = wm3d.mark(mesh.vertices, mesh.faces, key)
    report = wm3d.verify(marked.vertices, mesh.faces, key)
    assert report.verdict == "present"

Meshes are two arrays: V of shape (n, 3), real numbers, and F of shape (m, 3), numbers of rows of V. Long calls release the
interpreter's lock, call `progress(stage, done)` with `done` from 0 to 1 now and then, and can be interrupted.
Errors are wm3d.Error and its kinds, each with a sentence and a stable `code`, "bad_parameter" and the like.
"""
from __future__ import annotations

import dataclasses
import os
from typing import Callable, Literal, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import Error, GeometryError, InputError, Key, OutputError, ParameterError

__version__ = _core.version
__all__ = ["Error", "GeometryError", "InputError", "Key", "Marked", "MarkedFile", "Mesh", "OutputError", "ParameterError",
           "Report", "mark", "mark_file", "read", "verify"]

Path = Union[str, "os.PathLike[str]"]
Progress = Callable[[str, float], object]


@dataclasses.dataclass(frozen=True, eq=False)
class Mesh:
    """A mesh as it stands in a file: coinciding positions are one vertex, polygons are triangulated."""

    vertices: npt.NDArray[np.float64]  # (n, 3)
    faces: npt.NDArray[np.uint32]  # (m, 3)
    format: str  # "ply", "obj", ...


@dataclasses.dataclass(frozen=True, eq=False)
class Marked:
    """A marked mesh: other positions for the same faces. Percentages are of the bounding box's diagonal."""

    vertices: npt.NDArray[np.float64]  # (n, 3)
    profile: Literal["masked", "robust", "paper"]
    base_vertices: int  # that carry the mark
    level: int  # of the watermarking sphere
    rmax: float
    gamma: float  # of eq. (3), of bumps of the same strength
    rms_percent: float  # of the moves along the surface normal, weighted by area
    vertex_rms_percent: float
    max_percent: float
    msdm2: Optional[float]  # what is seen of it, one-sided, where it was measured


@dataclasses.dataclass(frozen=True)
class Report:
    """What a mesh says of a key."""

    verdict: Literal["present", "absent", "inconclusive"]
    log10_p: float  # of the probability that a random key scores like this, over all that was tried
    hypotheses: int  # that were tried, each of them paid for in log10_p
    bound: bool  # log10_p is a guaranteed bound, not an estimate
    sigmas: float  # score of the best hypothesis, in standard deviations under random keys
    doubt: Literal["none", "power", "alignment", "opening", "vertices", "axes"]  # why the verdict is inconclusive
    level: int
    pose: str
    base_vertices: int
    largest_opening_percent: float  # area that would close the widest border, of the surface
    expected_sigmas: float  # of a mark of the usual strength
    predicted_miss: float
    by_difference: bool  # the difference from the reference decided
    payload: Optional[str]  # a text, or digits after 0x; None where none is read
    payload_log10_p: Optional[float]  # of the probability, at most, that a random key would show any


@dataclasses.dataclass(frozen=True)
class MarkedFile:
    """What became of a file. Nothing is written where the mark would not be found again; `reason` says why."""

    written: bool
    reason: str
    marked: Marked
    check: Report


def read(path: Path, format: Optional[str] = None) -> Mesh:
    """Reads a mesh file: OBJ, PLY, STL, OFF, glTF or GLB, by its extension or by `format`."""
    return Mesh(*_core.read(path, format))


Profile = Literal["masked", "robust", "paper"]


def mark(V: npt.ArrayLike, F: npt.ArrayLike, key: Key, *, visibility: Optional[float] = None,
         strength: Optional[float] = None, gamma: Optional[float] = None, profile: Profile = "masked",
         payload: Optional[str] = None, base_vertices: Optional[int] = None, level: Optional[int] = None,
         rmax: Optional[float] = None, pf: float = 1e-6, progress: Optional[Progress] = None) -> Marked:
    """Hides the key's mark in a mesh. The same mesh, key and settings give the same bytes.

    visibility     one-sided MSDM2 that the mark keeps to; 0.1 where nothing else is said
    strength       root mean square move along the surface normal, % of the bounding box's diagonal, instead
    gamma          strength as gamma of the paper's eq. (3), instead
    profile        how the mark is laid out
    payload        what it says besides: up to 16 bytes of text, or up to 32 digits after 0x
    base_vertices  of the base domain
    level          of the watermarking sphere, one of the key's
    rmax           height of the bumps
    pf             false-positive probability at which the mark is to be found again
    """
    return Marked(**_core.mark(np.asarray(V), np.asarray(F), key, visibility=visibility, strength=strength, gamma=gamma,
                               profile=profile, payload=payload, base_vertices=base_vertices, level=level, rmax=rmax, pf=pf,
                               progress=progress))


def verify(V: npt.ArrayLike, F: npt.ArrayLike, key: Key, *, pf: float = 1e-6, receipt: Optional[Path] = None,
           reference: Optional[Tuple[npt.ArrayLike, npt.ArrayLike]] = None,
           search: Literal["when_needed", "never", "always"] = "when_needed", effort: float = 1,
           base_vertices: Optional[int] = None, progress: Optional[Progress] = None) -> Report:
    """Says whether the key's mark is in a mesh, with the exact probability that a random key scores like this on it.

    pf             false-positive probability of the verdict
    receipt        file that mark_file wrote: finds cut and ambiguous copies
    reference      the unmarked original, (V, F): align with it and look at the difference too
    search         whether every pose is searched where a quick look finds nothing
    effort         of that search: 1 takes a minute or two on two cores, 0 makes none
    base_vertices  to simplify the suspect to
    """
    original = None if reference is None else (np.asarray(reference[0]), np.asarray(reference[1]))
    return Report(**_core.verify(np.asarray(V), np.asarray(F), key, pf=pf, receipt=receipt, reference=original,
                                 search=search, effort=effort, base_vertices=base_vertices, progress=progress))


def mark_file(source: Path, target: Path, key: Key, *, visibility: Optional[float] = None,
              strength: Optional[float] = None, gamma: Optional[float] = None, profile: Profile = "masked",
              payload: Optional[str] = None, base_vertices: Optional[int] = None, level: Optional[int] = None, rmax: Optional[float] = None,
              pf: float = 1e-6, receipt: Optional[Path] = None, overwrite: bool = False,
              progress: Optional[Progress] = None) -> MarkedFile:
    """Marks a mesh file and verifies it before it is written. Only coordinates change; every other byte stays.

    receipt    also write what finds cut or ambiguous copies again
    overwrite  replace files that exist

    The others are as in mark.
    """
    result = _core.mark_file(source, target, key, visibility=visibility, strength=strength, gamma=gamma, profile=profile,
                             payload=payload, base_vertices=base_vertices, level=level, rmax=rmax, pf=pf, receipt=receipt, overwrite=overwrite, progress=progress)
    return MarkedFile(result["written"], result["reason"], Marked(**result["marked"]), Report(**result["check"]))
