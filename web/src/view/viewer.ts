// The view at work: what the reader does, what the store says, and what is drawn, kept together.
import type { PullEvent, RunData } from '../data';
import type { Store } from '../state';
import { scaleOf, show } from '../units';
import type { CameraDesk } from './desk/camera_desk';
import { Beside } from './states/beside';
import { Colouring } from './states/colouring';
import type { Frames } from './states/frames';
import { Inspector } from './desk/inspector';
import type { KeyActions } from './desk/keys';
import { Legend } from './desk/legend';
import { extentOfStates, type Model, modelOf } from './states/model';
import { nameEverything } from './scene/names';
import { Now } from './states/now';
import { pickedPlace, pickedRoller } from './desk/picked';
import { Playback, RATES } from './states/playback';
import { PlayerBar } from './desk/player_bar';
import { lengthText } from './states/quantity';
import { type Narrator, sentence } from './desk/sentence';
import { ToolBar } from './desk/tool_bar';
import type { World } from './scene/world';

type Choice = { roller: number } | { place: number } | null;

export class Viewer implements KeyActions {
  readonly model: Model;
  readonly beside: Beside;
  readonly playback: Playback;
  readonly legend = new Legend();
  readonly inspector: Inspector;
  readonly player: PlayerBar;
  readonly tools: ToolBar;
  now: Now | null = null;
  world: World | null = null;
  cameras: CameraDesk | null = null;
  forces: Frames | null = null;
  private readonly colouring: Colouring;
  private readonly events: PullEvent[];
  private stale = true;
  private choice: Choice = null;
  private hovered = -1;
  private request = 0;

  constructor(
    run: RunData,
    private readonly store: Store,
    private readonly narrator: Narrator,
    together: readonly RunData[] = [],
  ) {
    this.model = modelOf(run);
    this.beside = new Beside(together, this.model);
    this.colouring = new Colouring(this.model);
    const time = run.states?.time_s ?? [];
    this.playback = new Playback(time[0] ?? 0, time[time.length - 1] ?? 0);
    this.events = (run.summary.events ?? []).filter((event) => Number.isFinite(event.time_s));
    this.inspector = new Inspector(
      (at) => this.seek(at),
      () => this.leave(),
    );
    this.player = new PlayerBar(this.playback, this.events, this);
    this.tools = new ToolBar(this.model.bends, this.colouring.choices, this);
  }

  /** Takes the scene in, and the desk that moves its camera. */
  draws(world: World, cameras: CameraDesk): void {
    this.world = world;
    this.cameras = cameras;
    cameras.onChange = (bend, following) => {
      this.tools.atBend(bend);
      this.player.following(following);
    };
    world.stage.onFrame = (elapsed) => this.tick(elapsed);
  }

  /** Frames have come, or another field of them. */
  arrived(frames: Frames, name: string): void {
    if (name === 'position') {
      this.now = new Now(frames, this.model);
      extentOfStates(frames, this.model);
      if (!this.model.path) this.preset(0, true);
    }
    if (name === this.colouring.quantity.field) this.colour(name);
    this.refresh();
  }

  /** Frames of a run that goes on: more than before. Who looks at the newest one sees the next. */
  grown(frames: Frames): void {
    const { playback } = this;
    const newest = playback.time >= playback.to - 1e-9;
    playback.to = frames.to;
    if (newest && !playback.playing) playback.seek(frames.to);
    this.colouring.grown();
    for (const name of frames.fields.keys()) this.arrived(frames, name);
  }

  /** The same of a chain that is pulled together with this one. */
  besideArrived(which: number, frames: Frames): void {
    this.beside.arrived(which, frames);
    this.refresh();
  }

  /** Draws again, with everything taken anew from the frames. */
  refresh(): void {
    this.stale = true;
    if (this.world) this.world.stage.invalidate();
    else this.request ||= requestAnimationFrame(() => this.unseen());
  }

  /** Without a picture the clock and the words go on. */
  private unseen(): void {
    this.request = 0;
    if (this.tick(1 / 60)) this.refresh();
  }

  /** Goes on by the real time since the last picture; true if another picture has to follow. */
  tick(elapsed: number): boolean {
    const { playback, now, world } = this;
    if (playback.advance(elapsed)) {
      this.stale = true;
      this.store.set('time', playback.time, this);
    }
    if (now && this.stale && now.show(playback.time, this.colouring.quantity.field)) this.cameras?.goWithHead(now);
    if (this.stale) this.beside.show(playback.time, this.colouring.quantity.field);
    world?.update(this.stale ? now : null);
    if (now && this.stale) this.tell(now);
    this.stale = false;
    this.player.update();
    if (world) {
      world.updateLabels();
      this.legend.sizes(world.factor, world.ground.spacing, this.store.get('units'));
    }
    return playback.playing;
  }

  /** Labels of what moves, and the sentence. */
  private tell(now: Now): void {
    const system = this.store.get('units');
    const labels = this.world?.labels;
    const largest = now.largestTension;
    labels?.set('head', { text: 'Head', point: now.centre(this.model.head), weight: 90, kind: 'head' });
    if (largest && labels) {
      const text = `Largest ${show(largest.value, 'N', system, 3)}`;
      labels.set('largest', { text, point: now.centre(largest.segment), weight: 95, kind: 'largest' });
    }
    this.narrator.tell(() => sentence(now, this.model, system), this.playback.playing);
    this.inspector.at(now.time);
  }

  /** Shows a time that others point at: nobody has to be told. */
  showAt(time: number): void {
    this.playback.seek(time);
    this.refresh();
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

  factor(times: number | null): void {
    this.world?.exaggerate(times);
  }

  preset(index: number, atOnce = false): void {
    this.cameras?.preset(index, this.place, atOnce);
  }

  bend(index: number): void {
    this.cameras?.bend(index);
  }

  nextBend(step: number): void {
    this.cameras?.nextBend(step);
  }

  follow(on?: boolean): void {
    this.cameras?.follow(on);
  }

  toPlace(place = this.place): void {
    if (place !== null && this.model.path) this.cameras?.lookAt(this.model.path.at(place));
  }

  colour(field: string): void {
    const { colouring } = this;
    colouring.choose(field);
    const scale = colouring.scale(this.now?.frames);
    this.tools.coloured(field);
    this.world?.scale(scale);
    this.legend.scale(colouring.quantity, scale, this.store.get('units'));
    if (this.choice && 'place' in this.choice) this.inspect(this.choice);
    this.refresh();
  }

  nextColour(): void {
    this.colour(this.colouring.next.field);
  }

  /** Place that the reader points at, or else has chosen, m. */
  private get place(): number | null {
    return this.store.get('place') ?? (this.choice && 'place' in this.choice ? this.choice.place : null);
  }

  /** Shows figures over time of a roller or a place. */
  inspect(choice: Choice): void {
    this.choice = choice;
    const { model, now } = this;
    const system = this.store.get('units');
    const roller = choice && 'roller' in choice ? choice.roller : null;
    this.store.set('roller', roller, this);
    const ofPlace = choice && 'place' in choice && now;
    const picked =
      roller !== null
        ? pickedRoller(model, roller, this.forces, system)
        : ofPlace
          ? pickedPlace(model, choice.place, now, this.colouring.quantity, system)
          : null;
    this.inspector.show(picked, this.store.get('theme'));
    this.world?.rollers?.mark(roller ?? -1, -1);
    this.mark();
  }

  /** Shows the choice again, with what has changed or come. */
  inspectAgain(): void {
    if (this.choice) this.inspect(this.choice);
  }

  leave(): void {
    this.inspect(null);
  }

  /** The pointer is on that roller; -1: on none. */
  hover(roller: number): void {
    this.hovered = roller;
    this.mark();
  }

  /** A label where the reader points: a roller, or a place along the route. */
  mark(): void {
    const { model, world, place, hovered } = this;
    const name = model.run.geometry?.rollers[hovered]?.name.slice(0, 60);
    const at = place === null ? '' : lengthText(place, this.store.get('units'));
    const point = name ? world?.rollers?.centre(hovered) : place === null ? undefined : model.path?.at(place);
    const text = [name, at].filter(Boolean).join(' \u00b7 ');
    world?.labels.set('place', point ? { text, point, weight: 200, kind: 'place' } : null);
    world?.stage.invalidate();
  }

  /** Units or theme have changed. */
  redress(): void {
    const system = this.store.get('units');
    this.tools.units(system);
    if (this.world) {
      nameEverything(this.world.labels, this.model, system);
      this.world.unit = 1 / scaleOf('m', system, 1).factor;
      this.world.paint(this.store.get('theme'));
    }
    this.colour(this.colouring.quantity.field);
    this.inspectAgain();
    this.mark();
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.narrator.dispose();
    this.inspector.dispose();
    this.world?.dispose();
  }
}
