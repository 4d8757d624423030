#!/usr/bin/env python3
"""Draws OSGB tiles that were written as 3D Tiles with CesiumJS in Chromium.

    cesium_view_test.py FOLDER BIN OSGB_SAMPLE

As tileset_view_test.py; FOLDER gets the packages of cesium/package-lock.json and the pictures.
"""
import os
import sys
import tempfile

from npm_packages import chromium, fail, install, skip
from tileset_view_test import HERE, deliver, draw

LEVEL = 2  # of the pond at the middle of the scene, metres


def main():
    folder, program = os.path.abspath(sys.argv[1]), os.path.join(os.path.abspath(sys.argv[2]), 'tilemend')
    browser = chromium()
    if not browser:
        skip('there is no Chromium')
    install(folder, os.path.join(HERE, 'cesium'))
    with tempfile.TemporaryDirectory() as temporary:
        out = deliver(temporary, program, os.path.abspath(sys.argv[3]))
        coarse, fine = (draw(folder, out, browser, f'error={error}&height={LEVEL}', 'cesium_page.js')
                        for error in (300, 0.01))
    print(f'coarse: {coarse}, fine: {fine}')
    for result in (coarse, fine):
        if result['faults']:
            fail(result['faults'])
        if not result['colour'] or result['colour'] == [255, 0, 255, 255]:
            fail('the filled pond at the middle is not drawn')
    # Two tiles: one model each at the coarsest level, four at the finest.
    if coarse['models'] != 2 or fine['models'] != 8 or fine['triangles'] < 8 * coarse['triangles']:
        fail('the levels of detail are not those of the tiles')
    print('CesiumJS draws the tileset at its coarsest and finest level')


if __name__ == '__main__':
    main()
