// The frame of a tileset in the scene, as common/codec/tiles3d/tileset_frame.h has it.
import { Matrix4, Vector3 } from 'three';

const SEMI_MAJOR = 6378137, FLATTENING = 1 / 298.257223563; // WGS 84
const SQUARED = FLATTENING * (2 - FLATTENING);
const DEEP = 6.33e6, HIGH = 6.4e6; // what lies between is at the surface of the Earth, metres from its centre
const SAME_DIRECTION = 1e-10;

export interface Volume { box?: number[]; sphere?: number[]; region?: number[] }

const isOnEarth = (p: Vector3): boolean => p.length() > DEEP && p.length() < HIGH;

// Longitude and latitude of an Earth-centred point, radians (Bowring 1985).
function geodeticOf(p: Vector3): [number, number] {
  const minor = SEMI_MAJOR * (1 - FLATTENING), second = SQUARED / (1 - SQUARED), across = Math.hypot(p.x, p.y);
  const u = Math.atan2(p.z * SEMI_MAJOR, across * minor);
  const latitude = Math.atan2(p.z + second * minor * Math.sin(u) ** 3, across - SQUARED * SEMI_MAJOR * Math.cos(u) ** 3);
  return [Math.atan2(p.y, p.x), latitude];
}

function earthCentred(longitude: number, latitude: number, height: number): Vector3 {
  const radius = SEMI_MAJOR / Math.sqrt(1 - SQUARED * Math.sin(latitude) ** 2);
  return new Vector3((radius + height) * Math.cos(latitude) * Math.cos(longitude),
    (radius + height) * Math.cos(latitude) * Math.sin(longitude), (radius * (1 - SQUARED) + height) * Math.sin(latitude));
}

// East, north and up there, as columns.
function axesAt([longitude, latitude]: [number, number]): Matrix4 {
  const east = new Vector3(-Math.sin(longitude), Math.cos(longitude), 0);
  const north = new Vector3(-Math.sin(latitude) * Math.cos(longitude), -Math.sin(latitude) * Math.sin(longitude), Math.cos(latitude));
  return new Matrix4().makeBasis(east, north, new Vector3().crossVectors(east, north));
}

function middleOf(volume: Volume, transform: Matrix4): Vector3 {
  const { region } = volume;
  if (!region) return new Vector3().fromArray(volume.box ?? volume.sphere ?? [0, 0, 0]).applyMatrix4(transform);
  const east = region[2]! < region[0]! ? region[2]! + 2 * Math.PI : region[2]!;
  return earthCentred((region[0]! + east) / 2, (region[1]! + region[3]!) / 2, (region[4]! + region[5]!) / 2);
}

// From the frame of the root's parent to that of the scene.
export function sceneFrame(volume: Volume, transform: Matrix4): Matrix4 {
  const middle = middleOf(volume, transform);
  if (!isOnEarth(middle)) return new Matrix4();
  const origin = new Vector3().setFromMatrixPosition(transform);
  if (isOnEarth(origin)) {
    const up = new Vector3().setFromMatrixColumn(transform, 2), there = new Vector3().setFromMatrixColumn(axesAt(geodeticOf(origin)), 2);
    if (Math.abs(transform.determinant() - 1) < 1e-9 && up.dot(there) >= 1 - SAME_DIRECTION) return transform.clone().invert();
  }
  return axesAt(geodeticOf(middle)).setPosition(middle).invert();
}
