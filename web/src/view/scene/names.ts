// Labels that stand still: ends of the route, bends, machines, conveyors, distances.
import type { UnitSystem } from '../../state';
import { scaleOf } from '../../units';
import type { Label, Labels } from './labels';
import type { Model } from '../states/model';
import { lengthText } from '../states/quantity';
import { ticksOf } from '../states/scale';
import { bendText } from '../states/bends';

/** About how many distances stand along the route. */
const DISTANCES = 10;
const NAME_MAX = 40;

const short = (name: string): string => (name.length > NAME_MAX ? `${name.slice(0, NAME_MAX)}\u2026` : name);

export function nameEverything(labels: Labels, model: Model, system: UnitSystem): void {
  const { path, run, bends } = model;
  const geometry = run.geometry;
  const label = (name: string, text: string, point: Label['point'], weight: number, kind = 'name'): void =>
    labels.set(name, { text, point, weight, kind });
  if (path) {
    const { factor } = scaleOf('m', system, 1);
    const round = ticksOf(path.from * factor, path.to * factor, DISTANCES);
    for (let i = 0; i < 3 * DISTANCES; i++) {
      const s = (round[i] ?? 0) / factor;
      const text = lengthText(s, system).replace('.0', '');
      labels.set(`distance${i}`, i < round.length ? { text, point: path.at(s), weight: 10, kind: 'distance' } : null);
    }
    bends.forEach((bend, i) =>
      label(`bend${i}`, bendText(bend, system), path.at(0.5 * (bend.from + bend.to)), 20 + bend.angle),
    );
    for (const conveyor of geometry?.conveyors ?? [])
      label(`conveyor ${conveyor.name}`, short(conveyor.name), path.at(0.5 * (conveyor.from_m + conveyor.to_m)), 40);
  }
  if (geometry?.reel) label('reel', 'Reel', model.at(geometry.reel.center_m), 60);
  if (geometry?.winch) label('winch', 'Winch', model.at(geometry.winch.position_m), 60);
}
