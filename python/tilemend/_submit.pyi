# Written by scripts/python_stubs.py; a test holds it to the programs.
from typing import Literal, Optional, Union

from ._jobs import Job
from ._types import Path

class Submitter:
    def submit(self, scene: Path, out: Optional[Path] = None, *,
            priority: int = 0,
            request_id: Optional[str] = None,
            overwrite: Optional[bool] = None,
            dry_run: Optional[bool] = None,
            water: Union[Literal['auto', 'off'], Path, None] = None,
            clear: Optional[Path] = None,
            area: Optional[Path] = None,
            cells: Optional[str] = None,
            output_format: Optional[Literal['same', 'osgb', '3dtiles', 'obj', 'ply']] = None,
            link: Optional[bool] = None,
            tension: Union[Literal['auto'], float, None] = None,
            uniform: Optional[bool] = None,
            gradation: Optional[float] = None,
            size_limit: Optional[float] = None,
            water_profile: Optional[Literal['city', 'usgs']] = None,
            water_colour: Optional[str] = None,
            textures: Optional[Literal['copy', 'link', 'off']] = None,
            texture: Optional[Literal['synthesize', 'flat', 'none']] = None,
            decisions: Optional[Path] = None,
            surface: Optional[Literal['thin-plate', 'wang']] = None,
            filler: Optional[Literal['auto', 'advancing-front-normal', 'advancing-front-curvature', 'advancing-front-poisson', 'svm-laplacian', 'minimum-area']] = None,
            longest_loop: Optional[int] = None,
            fairing_steps: Optional[int] = None,
            seam_smoothing: Optional[float] = None,
            seam_buffer: Optional[float] = None,
            seam_points: Optional[Literal['projected', 'spaced']] = None,
            closure: Optional[Literal['buffers', 'line']] = None,
            front_steps: Optional[Literal['steady', 'printed']] = None,
        ) -> Job: ...
