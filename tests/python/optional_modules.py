"""Modules that the package works with where they are installed."""


WHERE = {
    'open3d': 'Debian: python3-open3d, which takes 280 MB and is not in scripts/packages.txt',
    'pyvista': 'not in Debian 12', 'trimesh': 'not in Debian 12'}


def need(test, name):
    """The module; skips the test, and says so, if it is not there."""
    try:
        return __import__(name)
    except ImportError:
        why = f'there is no {name} ({WHERE.get(name, f"Debian: python3-{name}")})'
        print(f'SKIPPED: {test.id().rsplit(".", 1)[1]}: {why}')
        test.skipTest(why)
