# Written by scripts/python_stubs.py; a test holds it to the programs.
from typing import Dict, List, Literal, Optional, Union

from ._filled import Filled
from ._types import FillProgress, Path, Rows

def options() -> List[Dict[str, str]]: ...
def fill(vertices: Rows, faces: Rows, *,
        progress: Optional[FillProgress] = None,
        surface: Optional[Literal['thin-plate', 'wang']] = None,
        filler: Optional[Literal['auto', 'advancing-front-normal', 'advancing-front-curvature', 'advancing-front-poisson', 'svm-laplacian', 'minimum-area']] = None,
        tension: Union[Literal['auto'], float, None] = None,
        uniform: Optional[bool] = None,
        gradation: Optional[float] = None,
        size_limit: Optional[float] = None,
        water: Union[Literal['auto', 'off'], Path, None] = None,
        water_profile: Optional[Literal['city', 'usgs']] = None,
        clear: Optional[Path] = None,
        allow_creases: Optional[bool] = None,
        weld: Union[Literal['off'], float, None] = None,
        dislocation_width: Union[Literal['auto'], float, None] = None,
        fill_outlines: Optional[bool] = None,
        largest_hole: Union[Literal['any'], int, None] = None,
        longest_loop: Optional[int] = None,
        fairing_steps: Optional[int] = None,
        front_steps: Optional[Literal['steady', 'printed']] = None,
        front_merge: Optional[float] = None,
        longest_rim: Optional[int] = None,
        filler_work: Optional[int] = None,
        front_bend: Union[Literal['auto'], float, None] = None,
        halvings: Optional[int] = None,
        centroid_steps: Optional[int] = None,
        long_edge: Optional[float] = None,
        svm_laplacian: Optional[Literal['area', 'mean']] = None,
        svm_rings: Optional[int] = None,
        svm_gamma: Optional[float] = None,
        svm_width: Optional[float] = None,
    ) -> Filled: ...
