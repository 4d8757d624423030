from typing import Any, Callable, Dict, List, Optional, Tuple

from numpy.typing import NDArray

RELEASE: str

def options() -> List[Dict[str, str]]: ...
def stages() -> List[Tuple[str, str]]: ...
def fill(vertices: NDArray[Any], faces: NDArray[Any], options: Dict[str, str],
         progress: Optional[Callable[[str, int, int], Any]]) -> Tuple[NDArray[Any], NDArray[Any], int, str]: ...
