// Reel, winch and obstacles: solids of their true size.
import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  Group,
  Matrix4,
  Mesh,
  Quaternion,
  type ShaderMaterial,
  TorusGeometry,
  Vector3,
} from 'three';
import type { Geometry, RunData } from '../../data';
import { valueAt } from '../../figure/align';
import { numbers } from '../../run';
import type { Part } from './equipment';
import type { Look } from './material';
import type { Model } from '../states/model';
import { cross, direction, dot, sub, type Vec3 } from '../states/path';

type Paint = (part: Part, look?: Omit<Look, 'colour'>) => ShaderMaterial;

const SPOKES = 6;

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
  const { radius_m: flange, width_m: width } = reel;
  const barrel = reel.barrel_radius_m ?? 0.6 * flange;
  const drum = stood(new CylinderGeometry(0.985 * barrel, 0.985 * barrel, width, 48), centre, reel.axis);
  const meshes = [new Mesh(drum, paint('drum'))];
  for (const end of [-0.5, 0.5]) {
    const disc = new CylinderGeometry(flange, flange, 0.02 * flange, 64);
    const side = new Mesh(
      stood(disc, centre, reel.axis, end * (width + 0.02 * flange)),
      paint('drum', { opacity: 0.3 }),
    );
    side.renderOrder = 1;
    meshes.push(side);
  }
  return meshes;
}

/** Spokes on both flanges, by which one sees that the reel turns: a group about its centre. */
export function reelSpokes(reel: NonNullable<Geometry['reel']>, model: Model, paint: Paint): Group {
  const { radius_m: flange, width_m: width } = reel;
  const group = new Group();
  const material = paint('frame');
  for (const end of [-1, 1])
    for (let k = 0; k < SPOKES; k++) {
      const spoke = new BoxGeometry(0.05 * flange, 0.02 * flange, 0.97 * flange).translate(0, 0, 0.485 * flange);
      spoke.rotateY((2 * Math.PI * k) / SPOKES);
      group.add(new Mesh(stood(spoke, [0, 0, 0], reel.axis, end * (0.5 * width + 0.03 * flange)), material));
    }
  group.position.set(...model.at(reel.center_m));
  return group;
}

/**
 * The angle by which the reel has turned about its axis at a time, rad: its speed of series.csv by the trapezoidal rule, which is positive
 * where it pays out; null without.
 */
export function reelAngle(run: RunData, model: Model): ((time: number) => number) | null {
  const reel = run.geometry?.reel;
  const time = numbers(run.series, 'time_s')?.map((t) => t ?? NaN);
  const speed = numbers(run.series, 'reel_speed_rad_per_s');
  if (!reel || !time || !speed || !model.path) return null;
  const out = sub(model.path.at(model.path.from), model.at(reel.center_m));
  const way = Math.sign(dot(cross(direction(reel.axis), out), model.path.tangent(model.path.from))) || 1;
  let sum = 0;
  const angle = time.map((t, i) => {
    if (i > 0) sum += 0.5 * ((speed[i] ?? 0) + (speed[i - 1] ?? 0)) * (t - time[i - 1]!);
    return way * sum;
  });
  return (at) => valueAt(time, angle, at) ?? 0;
}

/** A frame with a drum behind the point where the rope goes in. */
export function winchMesh(winch: NonNullable<Geometry['winch']>, model: Model, paint: Paint): Mesh[] {
  const [x, y, z] = model.at(winch.position_m);
  const ahead = direction([winch.direction[0], winch.direction[1], 0], [1, 0, 0]);
  const across: Vec3 = [-ahead[1], ahead[0], 0];
  const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...across));
  const frame = new BoxGeometry(1.1, 0.9, 0.5).applyMatrix4(new Matrix4().makeRotationFromQuaternion(turn));
  frame.translate(x + 0.45 * ahead[0], y + 0.45 * ahead[1], z - 0.65);
  const drum = stood(
    new CylinderGeometry(0.25, 0.25, 0.6, 32),
    [x + 0.3 * ahead[0], y + 0.3 * ahead[1], z - 0.25],
    across,
  );
  return [new Mesh(frame, paint('frame')), new Mesh(drum, paint('drum'))];
}

/** Boxes, and bell-mouths as rings, at the places of the rollers that they are. */
export function obstacleMeshes({ obstacles, rollers }: Geometry, model: Model, paint: Paint): Mesh[] {
  return (obstacles ?? []).flatMap((obstacle) => {
    const roller = rollers[obstacle.roller];
    if (!roller) return [];
    const at = model.at(roller.position_m);
    const axis = direction(roller.axis);
    if (obstacle.ring_m !== null) {
      const ring = new TorusGeometry(obstacle.ring_m, obstacle.edge_m ?? 0.1, 32, 64);
      return [new Mesh(stood(ring.rotateX(0.5 * Math.PI), at, axis), paint('obstacle', { opacity: 0.2 }))];
    }
    const side = direction(obstacle.side, [0, 1, 0]);
    const turn = new Matrix4().makeBasis(new Vector3(...axis), new Vector3(...side), new Vector3(...cross(axis, side)));
    const solid = new BoxGeometry(...obstacle.size_m).applyMatrix4(turn).translate(...at);
    return [new Mesh(solid, paint('obstacle'))];
  });
}
