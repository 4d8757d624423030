// The frame of a tileset in the scene, as common/codec/tiles3d/tileset_frame.h has it.
import { WGS84_ELLIPSOID } from '3d-tiles-renderer/three';
import { Matrix4, Vector3 } from 'three';

const DEEP = 6.33e6, HIGH = 6.4e6; // what lies between is at the surface of the Earth, metres from its centre
const SAME_DIRECTION = 1e-10;

export interface Volume { box?: number[]; sphere?: number[]; region?: number[] }

const isOnEarth = (p: Vector3): boolean => p.length() > DEEP && p.length() < HIGH;

// East, north and up at an Earth-centred point, as columns.
function axesAt(point: Vector3): Matrix4 {
  const { lat, lon } = WGS84_ELLIPSOID.getPositionToCartographic(point, {}), axes = [0, 1, 2].map(() => new Vector3()) as [Vector3, Vector3, Vector3];
  WGS84_ELLIPSOID.getEastNorthUpAxes(lat, lon, ...axes);
  return new Matrix4().makeBasis(...axes);
}

function middleOf(volume: Volume, transform: Matrix4): Vector3 {
  const { region } = volume;
  if (!region) return new Vector3().fromArray(volume.box ?? volume.sphere ?? [0, 0, 0]).applyMatrix4(transform);
  const east = region[2]! < region[0]! ? region[2]! + 2 * Math.PI : region[2]!;
  return WGS84_ELLIPSOID.getCartographicToPosition((region[1]! + region[3]!) / 2, (region[0]! + east) / 2,
    (region[4]! + region[5]!) / 2, new Vector3());
}

// From the frame of the root's parent to that of the scene.
export function sceneFrame(volume: Volume, transform: Matrix4): Matrix4 {
  const middle = middleOf(volume, transform);
  if (!isOnEarth(middle)) return new Matrix4();
  const origin = new Vector3().setFromMatrixPosition(transform);
  if (isOnEarth(origin)) {
    const up = new Vector3().setFromMatrixColumn(transform, 2), there = new Vector3().setFromMatrixColumn(axesAt(origin), 2);
    if (Math.abs(transform.determinant() - 1) < 1e-9 && up.dot(there) >= 1 - SAME_DIRECTION) return transform.clone().invert();
  }
  return axesAt(middle).setPosition(middle).invert();
}
