#!/usr/bin/env python3
"""tilemend.read_report, and what a report becomes in pandas and GeoPandas: report_test.py BIN PACKAGE"""
import json
import math
import os
import sys
import tempfile
import unittest

PACKAGE = sys.argv[2] if len(sys.argv) > 2 else None
sys.path.insert(0, PACKAGE)
import tilemend  # noqa: E402
from optional_modules import need  # noqa: E402

EMPTY = dict.fromkeys(('per_hole', 'left', 'warnings', 'water', 'look_at'), [])


class ReportTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='tilemend-report-')
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, data):
        with open(os.path.join(self.folder, name), 'w', encoding='utf-8') as file:
            json.dump(data, file)

    def test_says_what_is_missing(self):
        for path, text in ((self.folder, 'report.json: no such file; an output without it is not complete'),
                           (self.folder + '/none', '/none: no such folder'),
                           (self.folder + '/none/report.json', '/none: no such folder'),
                           (self.folder + '/other.json', 'other.json: no such file'),
                           ('nope', 'nope: no such folder'), ('nope.json', 'nope.json: no such file')):
            with self.assertRaises(tilemend.NotFound) as caught:
                tilemend.read_report(path)
            self.assertTrue(str(caught.exception).endswith(text), str(caught.exception))

    def test_bad_files_are_refused_by_name(self):
        path = os.path.join(self.folder, 'report.json')
        for text, fault in ((b'{', 'is not JSON'), (b'\xff', 'is not JSON'), (b'[]', 'expected an object, found list'),
                            (b'[' * 100000, 'is not JSON'), (b'{"per_hole": 3}', 'it has no list "per_hole"'),
                            (json.dumps({'per_hole': []}).encode(), 'it has no list "left"'),
                            (json.dumps(dict(EMPTY, review={})).encode(), 'it has no list "review"'),
                            (json.dumps(dict(EMPTY, per_hole=[3])).encode(), 'a row of "per_hole" is no object'),
                            (json.dumps(dict(EMPTY, review=[True])).encode(), 'a row of "review" is no object'),
                            (json.dumps(dict(EMPTY, warnings=[{}])).encode(), 'a row of "warnings" is no text'),
                            (b'{"a": ' + b'9' * 5000 + b'}', 'cannot be read: .*5000 digits')):
            with open(path, 'wb') as file:
                file.write(text)
            with self.assertRaisesRegex(tilemend.InvalidInput, fault):
                tilemend.read_report(path)

    def test_pipes_and_devices_are_refused_at_once(self):
        pipe = os.path.join(self.folder, 'pipe.json')
        os.mkfifo(pipe)
        for path in (pipe, '/dev/zero'):
            with self.assertRaisesRegex(tilemend.InvalidInput, 'is no regular file'):
                tilemend.read_report(path)

    def test_reads_a_report_without_newer_lists(self):
        self.write('report.json', dict(EMPTY, warnings=['w']))
        report = tilemend.read_report(self.folder)
        self.assertEqual((report.review, report.levels, report.cleared), ([], [], {}))
        self.assertEqual(repr(report), f"Report('{self.folder}/report.json': 0 holes filled, 0 left, 0 to review, 1 warning)")
        with self.assertRaisesRegex(tilemend.NotFound, 'holes.geojson: no such file'):
            report.write_decisions(os.path.join(self.folder, 'd.geojson'), {})

    def test_decisions_are_written_whole_and_over_no_file_of_the_output(self):
        self.write('report.json', EMPTY)
        ring = [[0, 0], [1, 0], [1, 1], [0, 0]]
        found = {'hole': 3, 'decision': 'water', 'level_m': 2.5, 'sigma_m': 0.1}
        self.write('holes.geojson', {'type': 'FeatureCollection', 'tilemend_scene': {'name': 'city'}, 'features': [
            {'type': 'Feature', 'properties': properties, 'geometry': {'type': 'Polygon', 'coordinates': [ring]}}
            for properties in (found, dict(found, hole=4, sigma_m=None))]})
        report = tilemend.read_report(self.folder)
        for name in ('report.json', 'holes.geojson'):
            with self.assertRaisesRegex(tilemend.InvalidInput, f'{name}: is a file of the output'):
                report.write_decisions(os.path.join(self.folder, name), {}, overwrite=True)
        with self.assertRaisesRegex(tilemend.InvalidInput, 'cannot be written'):
            report.write_decisions(os.path.join(self.folder, 'none', 'd.geojson'), {})
        path = os.path.join(self.folder, 'd.geojson')
        report.write_decisions(path, {})
        with open(path, encoding='utf-8') as file:
            written = json.load(file)
        rows = [feature['properties'] for feature in written['features']]
        self.assertEqual([(row['hole'], row['level_m']) for row in rows], [(3, None), (4, 2.5)])
        self.assertEqual(written['tilemend_scene'], {'name': 'city'})
        self.assertEqual(sorted(os.listdir(self.folder)), ['d.geojson', 'holes.geojson', 'report.json'])

    def test_damaged_files_are_errors_of_tilemend(self):
        polygon = {'type': 'Polygon', 'coordinates': [[[0, 0], [1, 0], [1, 1], [0, 0]]]}
        hole = {'type': 'Feature', 'properties': {'hole': 3}, 'geometry': polygon}
        row = {'id': 3, 'outcome': 'filled'}
        path = os.path.join(self.folder, 'd.geojson')
        for features in (3, None, [3], [dict(hole, properties=None)], [dict(hole, properties={})],
                         [dict(hole, properties={'hole': [3]})], [dict(hole, geometry=3)],
                         [{'type': 'Feature', 'properties': {'hole': 3}}]):
            self.write('report.json', dict(EMPTY, per_hole=[row]))
            self.write('holes.geojson', {'type': 'FeatureCollection', 'features': features})
            with self.subTest(features=features), self.assertRaisesRegex(tilemend.InvalidInput, 'holes.geojson: is no file'):
                tilemend.read_report(self.folder).write_decisions(path, {3: 'accept'})
        self.write('holes.geojson', {'type': 'FeatureCollection', 'tilemend_scene': 3, 'features': [hole]})
        with self.assertRaisesRegex(tilemend.InvalidInput, 'expected "tilemend_scene" to be an object'):
            tilemend.read_report(self.folder).write_decisions(path, {3: 'accept'})
        self.write('holes.geojson', {'type': 'FeatureCollection', 'features': [hole]})
        for key, damaged in (('per_hole', {}), ('per_hole', dict(row, id=[3])), ('review', {}),
                             ('review', {'holes': 'all'}), ('review', {'holes': None}),
                             ('review', {'holes': [3, 'x']}), ('review', {'holes': [3, []]})):
            self.write('report.json', dict(EMPTY, **{'per_hole': [row], key: [damaged]}))
            with self.subTest(damaged=damaged), self.assertRaisesRegex(tilemend.InvalidInput, 'is not as tilemend writes it'):
                tilemend.read_report(self.folder).write_decisions(path, {3: 'accept'})
        self.assertEqual(sorted(os.listdir(self.folder)), ['holes.geojson', 'report.json'])

    def test_tables_of_damaged_rows_are_errors_of_tilemend(self):
        need(self, 'pandas')
        row = {'id': 3, 'outcome': 'filled'}
        for damaged in (dict(row, cell=3), dict(row, centre=True), {}, dict(row, level_m=[1])):
            self.write('report.json', dict(EMPTY, per_hole=[damaged], review=[damaged]))
            report = tilemend.read_report(self.folder)
            for table in (report.holes_table, report.review_table):
                with self.subTest(damaged=damaged), self.assertRaisesRegex(tilemend.InvalidInput, 'report.json: is not as'):
                    table()

    def test_a_map_of_a_damaged_file_is_an_error_of_tilemend(self):
        need(self, 'geopandas')
        self.write('report.json', EMPTY)
        for features in (3, [{'type': 'Feature', 'properties': {'hole': 3},
                              'geometry': {'type': 'Polygon', 'coordinates': [[[0, 0], [1, 1]]]}}]):
            self.write('holes.geojson', {'type': 'FeatureCollection', 'features': features})
            with self.subTest(features=features), self.assertRaisesRegex(tilemend.InvalidInput, 'cannot be read as holes'):
                tilemend.read_report(self.folder).holes_map()

    def test_an_empty_path_is_no_folder(self):
        with self.assertRaisesRegex(tilemend.InvalidInput, 'an empty path'):
            tilemend.Client('127.0.0.1:9').submit('scene', '')

    def test_a_table_begins_with_the_place_and_has_one_empty_value(self):
        need(self, 'pandas')
        hole = {'id': 0, 'cell': [2, 1], 'kind': 'I', 'area_m2': 3.5, 'centre': [1, 2], 'outcome': 'filled'}
        self.write('report.json', dict(EMPTY, per_hole=[hole, dict(hole, id=1, reason='why', water={'taken_for': 'lake'})]))
        table = tilemend.read_report(self.folder).holes_table()
        self.assertEqual(list(table), ['column', 'row', 'x', 'y', 'kind', 'area_m2', 'outcome', 'taken_for', 'reason'])
        self.assertEqual(list(table.loc[0, ['column', 'row', 'taken_for', 'reason']]), [2, 1, None, None])
        self.write('report.json', dict(EMPTY, per_hole=[hole, dict(hole, id=1, centre=[1, 2, 3])]))
        self.assertEqual(tilemend.read_report(self.folder).holes_table()['z'][1], 3)

    def test_a_map_has_one_empty_value_for_each_column(self):
        need(self, 'geopandas')
        square = {'type': 'Polygon', 'coordinates': [[[0, 0], [1, 0], [1, 1], [0, 0]]]}
        empty = dict.fromkeys(('reason', 'water', 'level_m', 'cluster', 'taken_for', 'sigma_m'))
        rows = [dict(empty, hole=0), dict(empty, hole=1, taken_for='lake', sigma_m=0.5)]
        self.write('report.json', EMPTY)
        self.write('holes.geojson', {'type': 'FeatureCollection', 'features': [
            {'type': 'Feature', 'properties': row, 'geometry': square} for row in rows]})
        holes = tilemend.read_report(self.folder).holes_map()
        for name in ('reason', 'water', 'taken_for'):
            self.assertIsNone(holes[name][0], name)
        for name in ('level_m', 'cluster', 'sigma_m'):
            self.assertTrue(math.isnan(holes[name][0]), name)
        self.assertEqual((holes['taken_for'][1], holes['sigma_m'][1]), ('lake', 0.5))


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=1)
