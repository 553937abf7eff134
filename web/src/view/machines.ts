// Reel, winch and obstacles: solids of their true size.
import { BoxGeometry, BufferGeometry, CylinderGeometry, Matrix4, Mesh, Quaternion, type ShaderMaterial, SphereGeometry, Vector3 } from 'three';
import type { Geometry } from '../data';
import type { Part } from './equipment';
import type { Look } from './material';
import type { Model } from './model';
import { direction, type Vec3 } from './path';

type Paint = (part: Part, look?: Omit<Look, 'colour'>) => ShaderMaterial;

/** A solid made about the origin with its axis along y, moved to a point with its axis along `axis`. */
function stood(geometry: BufferGeometry, at: Vec3, axis: Vec3, shift = 0): BufferGeometry {
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...direction(axis, [0, 1, 0])));
  geometry.translate(0, shift, 0);
  geometry.applyMatrix4(new Matrix4().makeRotationFromQuaternion(turn));
  return geometry.translate(...at);
}

/** Drum and two flanges that one can see the cable through. */
export function reelMesh(reel: NonNullable<Geometry['reel']>, model: Model, paint: Paint): Mesh[] {
  const centre = model.at(reel.center_m);
  const { radius_m: radius, width_m: width } = reel;
  const drum = stood(new CylinderGeometry(0.985 * radius, 0.985 * radius, width, 48), centre, reel.axis);
  const meshes = [new Mesh(drum, paint('drum'))];
  for (const end of [-0.5, 0.5]) {
    const disc = new CylinderGeometry(1.35 * radius, 1.35 * radius, 0.03 * radius, 48);
    const flange = new Mesh(stood(disc, centre, reel.axis, end * 1.05 * width), paint('drum', { opacity: 0.3 }));
    flange.renderOrder = 1;
    meshes.push(flange);
  }
  return meshes;
}

/** A frame with a drum behind the point where the rope goes in. */
export function winchMesh(winch: NonNullable<Geometry['winch']>, model: Model, paint: Paint): Mesh[] {
  const [x, y, z] = model.at(winch.position_m);
  const ahead = direction([winch.direction[0], winch.direction[1], 0], [1, 0, 0]);
  const across: Vec3 = [-ahead[1], ahead[0], 0];
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...across));
  const frame = new BoxGeometry(1.1, 0.9, 0.5).applyMatrix4(new Matrix4().makeRotationFromQuaternion(turn));
  frame.translate(x + 0.45 * ahead[0], y + 0.45 * ahead[1], z - 0.65);
  const drum = stood(new CylinderGeometry(0.25, 0.25, 0.6, 32), [x + 0.3 * ahead[0], y + 0.3 * ahead[1], z - 0.25], across);
  return [new Mesh(frame, paint('frame')), new Mesh(drum, paint('drum'))];
}

/** What an obstacle may say of itself; what is missing has a usual size. */
interface Obstacle {
  name?: string;
  position_m?: Vec3;
  points_m?: Vec3[];
  axis?: Vec3;
  radius_m?: number;
  length_m?: number;
  size_m?: Vec3;
}

export function obstacleMeshes(obstacles: readonly unknown[], model: Model, paint: Paint): Mesh[] {
  return (obstacles as Obstacle[]).flatMap((obstacle) => {
    const points = obstacle.position_m ? [obstacle.position_m] : (obstacle.points_m ?? []);
    return points.map((point) => {
      const at = model.at(point);
      const radius = obstacle.radius_m ?? 0.1;
      const solid = obstacle.size_m
        ? new BoxGeometry(...obstacle.size_m).translate(...at)
        : obstacle.axis
          ? stood(new CylinderGeometry(radius, radius, obstacle.length_m ?? 0.5, 32), at, obstacle.axis)
          : new SphereGeometry(radius, 32, 16).translate(...at);
      return new Mesh(solid, paint('obstacle'));
    });
  });
}
