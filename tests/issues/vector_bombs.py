"""Small vector files that take GDAL very much time or memory."""
import json
import random
import sqlite3

# The columns that a GeoPackage needs of its own tables.
TABLES = '''
CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT, srs_id INTEGER PRIMARY KEY, organization TEXT,
  organization_coordsys_id INTEGER, definition TEXT, description TEXT);
CREATE TABLE gpkg_contents (table_name TEXT PRIMARY KEY, data_type TEXT, identifier TEXT, description TEXT,
  last_change TEXT, min_x REAL, min_y REAL, max_x REAL, max_y REAL, srs_id INTEGER);
CREATE TABLE gpkg_geometry_columns (table_name TEXT, column_name TEXT, geometry_type_name TEXT, srs_id INTEGER,
  z INTEGER, m INTEGER);
INSERT INTO gpkg_spatial_ref_sys VALUES ('none', -1, 'NONE', -1, 'undefined', '');
INSERT INTO gpkg_contents VALUES ('lakes', 'features', 'lakes', '', '2020-01-01T00:00:00Z', 0, 0, 1, 1, -1);
INSERT INTO gpkg_geometry_columns VALUES ('lakes', 'geom', 'POLYGON', -1, 0, 0);
'''


def endless_view(path):
    """A GeoPackage whose layer is a view over a query that never ends."""
    with sqlite3.connect(path) as package:
        package.executescript(f'''PRAGMA application_id = {0x47504B47}; PRAGMA user_version = 10300;{TABLES}
            CREATE VIEW lakes AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)
              SELECT i AS fid, NULL AS geom FROM n;''')
    package.close()


def geojson(path, rings):
    geometry = {'type': 'Polygon', 'coordinates': rings}
    feature = {'type': 'Feature', 'properties': {}, 'geometry': geometry}
    with open(path, 'w') as file:
        json.dump({'type': 'FeatureCollection', 'features': [feature]}, file)


def crossing_ring(path, points):
    """A polygon of random points, most of whose edges cross each other."""
    numbers = random.Random(1)
    ring = [[numbers.uniform(0, 40), numbers.uniform(0, 40)] for _ in range(points)]
    geojson(path, [ring + ring[:1]])


def many_holes(path, holes):
    def square(x, y, side):
        return [[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]

    side = 40 / (holes ** 0.5 + 2)
    count = int(holes ** 0.5)
    inner = [square((column + 1) * side, (row + 1) * side, side / 2) for column in range(count) for row in range(count)]
    geojson(path, [square(0, 0, 40), *inner])
