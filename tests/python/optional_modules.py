"""Modules that the package works with where they are installed."""


def need(test, name):
    """The module; skips the test, and says so, if it is not there."""
    try:
        return __import__(name)
    except ImportError:
        print(f'SKIPPED: {test.id().rsplit(".", 1)[1]}: there is no {name}')
        test.skipTest(f'there is no {name}')
