"""Showing shapes: the page of the command's `view`, in a notebook or in a file."""

from __future__ import annotations

import html
import os
from typing import TYPE_CHECKING

import toccata

if TYPE_CHECKING:
    from ._typing import ObjectsLike


class Page:
    """A self-contained HTML page. A notebook shows it where it is the last thing of a cell."""

    def __init__(self, text: str, height: int = 600) -> None:
        self.html = text
        self.height = height

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes it to a file; raises Error where that exists and was not written by Toccata."""
        toccata.write_view_page(self.html, os.fspath(path))

    def _repr_html_(self) -> str:
        inside = html.escape(self.html, quote=True)
        return f'<iframe srcdoc="{inside}" style="width: 100%; height: {self.height}px; border: 0"></iframe>'

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Page) and (self.html, self.height) == (other.html, other.height)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<toccata.Page of {len(self.html)} characters>"


def show(
    objects: ObjectsLike,
    path: str | os.PathLike[str] | None = None,
    *,
    title: str = "Toccata",
    up: str = "z",
    faces: bool = True,
    penetration: bool = True,
    clearance: float | None = None,
    height: int = 600,
) -> Page:
    """Shows posed shapes and where they meet: in a notebook inline, and with a path in a file that any browser opens.

    The objects are shapes, pairs (shape, pose), or SceneInstances, whose names the page tells. What it draws of each pair is
    what check_all finds: which faces meet (faces), how deep (penetration), and with a clearance how far apart, in the unit of
    the coordinates. up: the axis that points up, 'y' or 'z'; height: that in a notebook, in pixels. Raises Error like
    check_all, and where the file exists and was not written by Toccata.
    """
    text = toccata.view_page(objects, title=title, up=up, faces=faces, penetration=penetration, clearance=clearance)
    page = Page(text, height)
    if path is not None:
        page.write(path)
    return page
