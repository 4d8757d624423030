#!/usr/bin/env python3
"""Fills scenes of OBJ with images, of 3D Tiles and of OSGB, and looks at their holes in the coordinator's page.

    console_pictures_test.py FOLDER BIN OSGB_SAMPLE DRACO_SAMPLE

FOLDER and BIN as in console_page_test.py; the last two are programs that write a made scene of OSGB tiles, and a tileset
with Draco. Exit code 77 (skipped, and says so) without npm, its registry or Chromium.
"""
import os
import shutil
import subprocess
import sys
import tempfile

import textured_scenes
from console_cluster import Cluster
from npm_packages import chromium, fail, install, run, skip

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    folder, programs = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    install(folder)
    browser = chromium()
    if not browser:
        skip('there is no Chromium')
    for name in ('console_tab.mjs', 'open_pictures.mjs'):
        shutil.copy(os.path.join(HERE, name), folder)
    with tempfile.TemporaryDirectory() as temporary:
        cluster = Cluster(temporary, programs)
        scenes = {'obj': textured_scenes.obj_scene(cluster.path('obj')),
                  'tiles3d': textured_scenes.tileset_scene(cluster.path('tiles3d')), 'osgb': cluster.path('osgb'), 'draco': cluster.path('draco')}
        for name, program in (('osgb', sys.argv[3]), ('draco', sys.argv[4])):
            done = run(os.path.abspath(program), scenes[name])
            if done.returncode:
                fail(done.stdout)
        try:
            cluster.start()
            cluster.start_worker()
            jobs = [f"{name}={cluster.submit(scene, '--wait')['name']}" for name, scene in scenes.items()]
            script = subprocess.run(['node', 'open_pictures.mjs', f'http://{cluster.web}', browser, folder, *jobs], cwd=folder,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=250)
            print(script.stdout, end='')
            if script.returncode:
                fail('the pictures are not as they should be')
        finally:
            cluster.close()
    print('holes of all formats are shown before and after')


if __name__ == '__main__':
    main()
