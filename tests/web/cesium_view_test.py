#!/usr/bin/env python3
"""Draws OSGB tiles that were written as 3D Tiles with CesiumJS in Chromium.

    cesium_view_test.py FOLDER BIN OSGB_SAMPLE

As tileset_view_test.py; FOLDER gets the packages of cesium/package-lock.json and the picture.
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
        result = draw(folder, out, browser, f'error=0.01&height={LEVEL}', 'cesium_page.js')
    print(result)
    if result['faults']:
        fail(result['faults'])
    if not result['colour'] or result['colour'] == [255, 0, 255, 255]:
        fail('the filled pond at the middle is not drawn')
    if result['models'] != 8:
        fail('the finest level of two tiles has four models each')
    print('CesiumJS draws the tileset at its finest level')


if __name__ == '__main__':
    main()
