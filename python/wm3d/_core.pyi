# SPDX-License-Identifier: GPL-3.0-or-later
import os
from typing import Any, Callable, Dict, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

_Path = Union[str, os.PathLike[str]]
_Progress = Callable[[str, float], object]

version: str

class Error(RuntimeError):
    code: str

class InputError(Error): ...
class OutputError(Error): ...
class GeometryError(Error): ...
class ParameterError(Error): ...

class Key:
    """An owner's key: 256 secret bits and public parameters. The secret never becomes a Python object."""

    @staticmethod
    def generate(name: str = ...) -> Key: ...
    @staticmethod
    def load(path: _Path, passphrase: Optional[str] = ...) -> Key: ...
    def save(self, path: _Path, passphrase: Optional[str] = ...) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def fingerprint(self) -> str: ...
    @property
    def commitment(self) -> str: ...

def mark(V: npt.NDArray[Any], F: npt.NDArray[Any], key: Key, *, visibility: Optional[float] = ...,
         strength: Optional[float] = ..., gamma: Optional[float] = ..., profile: Optional[str] = ..., payload: Optional[str] = ...,
         base_vertices: Optional[int] = ..., level: Optional[int] = ..., rmax: Optional[float] = ..., pf: float = ...,
         progress: Optional[_Progress] = ...) -> Dict[str, Any]: ...
def verify(V: npt.NDArray[Any], F: npt.NDArray[Any], key: Key, *, pf: float = ...,
           receipt: Optional[_Path] = ..., reference: Optional[Tuple[npt.NDArray[Any], npt.NDArray[Any]]] = ...,
           search: Optional[str] = ..., effort: float = ..., base_vertices: Optional[int] = ...,
           progress: Optional[_Progress] = ...) -> Dict[str, Any]: ...
def mark_file(source: _Path, target: _Path, key: Key, *, visibility: Optional[float] = ...,
              strength: Optional[float] = ..., gamma: Optional[float] = ..., profile: Optional[str] = ...,
              payload: Optional[str] = ..., base_vertices: Optional[int] = ..., level: Optional[int] = ..., rmax: Optional[float] = ..., pf: float = ...,
              receipt: Optional[_Path] = ..., overwrite: bool = ...,
              progress: Optional[_Progress] = ...) -> Dict[str, Any]: ...
def read(path: _Path, format: Optional[str] = ...) -> Tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32], str]: ...
