// What the reader wants of the camera: presets, bends, following the head, a nearer look.
import { along, bendPose, overview, plan, type Pose, poseAt, profile } from '../scene/cameras';
import type { Model } from '../states/model';
import type { Now } from '../states/now';
import { sub, type Vec3 } from '../states/path';
import type { World } from '../scene/world';

/** Farthest that the camera follows the head from, m. */
const FOLLOW_M = 60;

/** Distance of the camera along the cable, m; farther for thicker cables. */
const nearby = (model: Model): number => Math.max(2.5, 40 * model.diameter);

export class CameraDesk {
  private followed: Vec3 | null = null;
  private atBend = -1;
  /** Told which bend is looked at, if any, and whether the head is followed. */
  onChange: (bend: number | null, following: boolean) => void = () => {};

  constructor(
    private readonly world: World,
    private readonly now: () => Now | null,
    /** Simulated time that is shown or is about to be, s. */
    private readonly time: () => number,
  ) {}

  private get model(): Model {
    return this.world.model;
  }

  private changed(): void {
    this.onChange(this.atBend < 0 ? null : this.atBend, this.followed !== null);
  }

  /** Preset of that index (tool_bar.ts); `place` is where the reader points, m. */
  preset(index: number, place: number | null, atOnce = false): void {
    const { extent } = this.model;
    const { stage } = this.world;
    const poses: (() => Pose)[] = [
      () => overview(extent, stage.aspect),
      () => this.behind(place),
      () => plan(extent, stage.aspect),
      () => profile(extent, stage.aspect),
    ];
    if (index !== 1) this.followed = null;
    this.atBend = -1;
    stage.go(poses[index]!(), atOnce);
    this.changed();
  }

  /** Behind a place, or behind the head. */
  private behind(place: number | null): Pose {
    const { model } = this;
    const now = this.now();
    if (!model.path) return poseAt(this.world.stage.pose, now?.centre(model.head) ?? [0, 0, 0], nearby(model));
    const head = now?.headPlace(this.time()) ?? model.path.from;
    return along(model.path, place ?? Math.min(model.path.to, head), nearby(model));
  }

  bend(index: number): void {
    const { bends, path } = this.model;
    const bend = bends[index];
    if (!path || !bend) return;
    this.followed = null;
    this.atBend = index;
    this.world.stage.go(bendPose(path, bend, this.world.stage.aspect));
    this.changed();
  }

  nextBend(step: number): void {
    const n = this.model.bends.length;
    if (n > 0) this.bend((this.atBend + step + (this.atBend < 0 && step < 0 ? 1 : 0) + n) % n);
  }

  follow(on = !this.followed): void {
    const now = this.now();
    const { stage } = this.world;
    this.followed = on && now ? now.centre(this.model.head) : null;
    if (this.followed) stage.go(poseAt(stage.pose, this.followed, Math.min(stage.distance, FOLLOW_M)));
    this.changed();
  }

  /** Moves with the head to where it is now. */
  goWithHead(now: Now): void {
    if (!this.followed) return;
    const head = now.centre(this.model.head);
    this.world.stage.shift(sub(head, this.followed));
    this.followed = head;
  }

  /** Nearer to a point, from the same side. */
  lookAt(point: Vec3): void {
    const { stage } = this.world;
    stage.go(poseAt(stage.goal, point, nearby(this.model) * 2));
  }
}
