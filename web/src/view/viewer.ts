// The view at work: what the reader does, what the store says, and what is drawn, kept together.
import type { RunData } from '../data';
import type { Store } from '../state';
import { show } from '../units';
import { along, bendPose, overview, plan, poseAt, profile, type Pose } from './cameras';
import type { Frames } from './frames';
import { Inspector } from './inspector';
import type { KeyActions } from './keys';
import { Legend } from './legend';
import { modelOf, onReel, type Model } from './model';
import { nameEverything } from './names';
import { Now } from './now';
import { Playback, RATES } from './playback';
import { sub, type Vec3 } from './path';
import { pickedPlace, pickedRoller } from './picked';
import { PlayerBar } from './player_bar';
import { lengthText, QUANTITIES, type Quantity } from './quantity';
import { scaleOf, type Scale } from './scale';
import { Narrator, sentence } from './sentence';
import { ToolBar } from './tool_bar';
import type { World } from './world';

type Choice = { roller: number } | { place: number } | null;

/** Distance of the camera along the cable and at a place, m; farther for thicker cables. */
const nearby = (model: Model): number => Math.max(2.5, 40 * model.diameter);

export class Viewer implements KeyActions {
  readonly model: Model;
  readonly playback: Playback;
  readonly legend = new Legend();
  readonly inspector: Inspector;
  readonly player: PlayerBar;
  readonly tools: ToolBar;
  now: Now | null = null;
  world: World | null = null;
  forces: { frames: Frames; field: string } | null = null;
  private quantity: Quantity = QUANTITIES[0]!;
  private readonly scales = new Map<string, Scale | null>();
  private stale = true;
  private followed: Vec3 | null = null;
  private choice: Choice = null;
  private atBend = -1;
  private request = 0;
  private readonly events: { time_s: number; what: string; pull_N: number | null }[];

  constructor(
    run: RunData,
    private readonly store: Store,
    private readonly narrator: Narrator,
  ) {
    this.model = modelOf(run);
    const time = run.states?.time_s ?? [];
    this.playback = new Playback(time[0] ?? 0, time[time.length - 1] ?? 0);
    this.events = (run.summary.events ?? []).filter((event) => Number.isFinite(event.time_s));
    this.inspector = new Inspector(
      (at) => this.seek(at),
      () => this.leave(),
    );
    this.player = new PlayerBar(this.playback, this.events, {
      toggle: () => this.toggle(),
      seek: (at) => this.seek(at),
      event: (step) => this.event(step),
      follow: (on) => this.setFollow(on),
    });
    const quantities = QUANTITIES.filter(({ field }) => !run.states || field in run.states.packed);
    this.quantity = quantities[0] ?? this.quantity;
    this.tools = new ToolBar(this.model.bends, quantities, {
      preset: (index) => this.preset(index),
      bend: (index) => this.bend(index),
      colour: (field) => this.colour(field),
      factor: (times) => this.world?.exaggerate(times),
    });
  }

  /** Frames have come, or another field of them. */
  arrived(frames: Frames, name: string): void {
    if (!this.now && name === 'position') this.now = new Now(frames, this.model);
    if (name === this.quantity.field) this.colour(name);
    this.refresh();
  }

  /** Draws again, with everything taken anew from the frames. */
  refresh(): void {
    this.stale = true;
    if (this.world) this.world.stage.invalidate();
    else this.request ||= requestAnimationFrame(() => {
      this.request = 0;
      if (this.tick(1 / 60)) this.refresh();
    });
  }

  /** Goes on by the real time since the last picture; true if another picture has to follow. */
  tick(elapsed: number): boolean {
    const { playback, now, world } = this;
    if (playback.advance(elapsed)) {
      this.stale = true;
      this.store.set('time', playback.time, this);
    }
    if (now && this.stale && now.show(playback.time, this.quantity.field)) this.goWithHead();
    world?.update(this.stale ? now : null);
    if (now && this.stale) this.tell();
    this.stale = false;
    this.player.update();
    if (world) {
      world.updateLabels();
      this.legend.sizes(world.factor, world.ground.spacing, this.store.get('units'));
    }
    return playback.playing;
  }

  /** Labels of what moves, and the sentence. */
  private tell(): void {
    const now = this.now!;
    const system = this.store.get('units');
    const labels = this.world?.labels;
    const largest = now.largestTension;
    labels?.set('head', { text: 'Head', point: now.centre(this.model.head), weight: 90, kind: 'head' });
    if (largest && labels)
      labels.set('largest', {
        text: `Largest ${show(largest.value, 'N', system, 3)}`,
        point: now.centre(largest.segment),
        weight: 95,
        kind: 'largest',
      });
    this.narrator.tell(() => sentence(now, this.model, system), this.playback.playing);
    this.inspector.at(now.time);
  }

  private goWithHead(): void {
    if (!this.followed || !this.now || !this.world) return;
    const head = this.now.centre(this.model.head);
    this.world.stage.shift(sub(head, this.followed));
    this.followed = head;
  }

  seek(time: number): void {
    this.playback.seek(time);
    this.store.set('time', this.playback.time, this);
    this.refresh();
  }

  toggle(): void {
    this.playback.toggle();
    this.refresh();
  }

  step(frames: number): void {
    const all = this.now?.frames;
    if (!all) return;
    this.playback.playing = false;
    const { frame, part } = all.between(this.playback.time);
    const from = frames < 0 && part > 1e-6 ? frame + 1 : frame;
    this.seek(all.time[Math.min(all.count - 1, Math.max(0, from + frames))]!);
  }

  end(last: boolean): void {
    this.seek(last ? this.playback.to : this.playback.from);
  }

  faster(step: number): void {
    const at = RATES.indexOf(this.playback.rate) + step;
    this.playback.rate = RATES[Math.min(RATES.length - 1, Math.max(0, at))]!;
    this.player.rated();
  }

  event(step: number): void {
    const { time } = this.playback;
    const times = this.events.map((event) => event.time_s).sort((a, b) => a - b);
    const found = step > 0 ? times.find((at) => at > time + 1e-6) : times.filter((at) => at < time - 1e-6).pop();
    if (found !== undefined) this.seek(found);
  }

  zoom(by: number): void {
    this.world?.stage.zoom(by);
  }

  orbit(round: number, up: number): void {
    this.world?.stage.orbit(round, up);
  }

  follow(): void {
    this.setFollow(!this.followed);
  }

  setFollow(on: boolean): void {
    const { now, world } = this;
    this.followed = on && now ? now.centre(this.model.head) : null;
    this.player.following(this.followed !== null);
    if (this.followed && world) world.stage.go(poseAt(world.stage.pose, this.followed, Math.min(world.stage.distance, 60)));
  }

  preset(index: number, atOnce = false): void {
    const { world, model } = this;
    if (!world) return;
    const { aspect } = world.stage;
    const poses: (() => Pose)[] = [
      () => overview(model.extent, aspect),
      () => this.behindHead(),
      () => plan(model.extent, aspect),
      () => profile(model.extent, aspect),
    ];
    if (index !== 1) this.setFollow(false);
    this.atBend = -1;
    this.tools.atBend(null);
    world.stage.go(poses[index]!(), atOnce);
  }

  private behindHead(): Pose {
    const { model, now } = this;
    const place = this.store.get('place');
    if (!model.path) return poseAt(this.world!.stage.pose, now?.centre(model.head) ?? [0, 0, 0], nearby(model));
    const s = place ?? now?.headPlace() ?? model.path.from;
    return along(model.path, s, nearby(model));
  }

  bend(index: number): void {
    const { world, model } = this;
    const bend = model.bends[index];
    if (!world || !model.path || !bend) return;
    this.setFollow(false);
    this.atBend = index;
    this.tools.atBend(index);
    world.stage.go(bendPose(model.path, bend, world.stage.aspect));
  }

  nextBend(step: number): void {
    const n = this.model.bends.length;
    if (n > 0) this.bend((this.atBend + step + (this.atBend < 0 && step < 0 ? 1 : 0) + n) % n);
  }

  colour(field: string): void {
    this.quantity = QUANTITIES.find((quantity) => quantity.field === field) ?? this.quantity;
    const frames = this.now?.frames;
    if (frames?.fields.has(field) && !this.scales.has(field)) this.scales.set(field, scaleOf(frames, field, this.wound(frames)));
    const scale = this.scales.get(field) ?? null;
    this.tools.coloured(field);
    this.world?.scale(scale);
    this.legend.scale(this.quantity, scale, this.store.get('units'));
    if (this.choice && 'place' in this.choice) this.inspect(this.choice);
    this.refresh();
  }

  nextColour(): void {
    const here = QUANTITIES.filter(({ field }) => this.now?.frames.fields.has(field));
    const at = here.indexOf(this.quantity);
    if (here.length > 0) this.colour(here[(at + 1) % here.length]!.field);
  }

  /** Cable on the reel does not count for the colours: it is bent more than anything on the route. */
  private wound(frames: Frames): ((item: number, frame: number) => boolean) | undefined {
    const field = frames.fields.get('position');
    if (!this.model.run.geometry?.reel || !field) return undefined;
    const inside = onReel(this.model);
    const [x, y, z] = this.model.centre;
    const { q, meta } = field;
    return (item, frame) => {
      const at = 3 * (frame * frames.items + item);
      return inside(q[at]! * meta.step - x, q[at + 1]! * meta.step - y, q[at + 2]! * meta.step - z);
    };
  }

  /** Shows figures over time of a roller or a place. */
  inspect(choice: Choice): void {
    this.choice = choice;
    const { model, now } = this;
    const system = this.store.get('units');
    const roller = choice && 'roller' in choice ? choice.roller : null;
    this.store.set('roller', roller, this);
    const picked =
      roller !== null
        ? pickedRoller(model, roller, this.forces, system)
        : choice && 'place' in choice && now
          ? pickedPlace(model, choice.place, now, this.quantity, system)
          : null;
    this.inspector.show(picked, this.store.get('theme'));
    this.mark(choice && 'place' in choice ? choice.place : this.store.get('place'));
    this.world?.rollers?.mark(roller ?? -1, -1);
    this.world?.stage.invalidate();
  }

  /** Shows the choice again, in other units or colours. */
  inspectAgain(): void {
    if (this.choice) this.inspect(this.choice);
  }

  leave(): void {
    this.inspect(null);
  }

  /** A label where the store's place is. */
  mark(s: number | null): void {
    const { model, world } = this;
    const chosen = this.choice && 'place' in this.choice ? this.choice.place : null;
    const at = s ?? chosen;
    const label =
      at === null || !model.path
        ? null
        : { text: lengthText(at, this.store.get('units')), point: model.path.at(at), weight: 200, kind: 'place' };
    world?.labels.set('place', label);
    world?.stage.invalidate();
  }

  toPlace(): void {
    const s = this.store.get('place') ?? (this.choice && 'place' in this.choice ? this.choice.place : null);
    if (s !== null && this.model.path) this.lookAt(this.model.path.at(s));
  }

  /** Nearer to a point, from the same side. */
  lookAt(point: Vec3): void {
    const stage = this.world?.stage;
    if (stage) stage.go(poseAt(stage.goal, point, nearby(this.model) * 2));
  }

  /** Units or theme have changed. */
  redress(): void {
    const system = this.store.get('units');
    this.tools.units(system);
    if (this.world) {
      nameEverything(this.world.labels, this.model, system);
      this.world.paint(this.store.get('theme'));
    }
    this.colour(this.quantity.field);
    this.inspectAgain();
    this.mark(this.store.get('place'));
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.narrator.dispose();
    this.inspector.dispose();
    this.world?.dispose();
  }
}
