// The scene: everything that is drawn, for a model; what is under the pointer in it.
import type { Theme } from '../../state';
import { ChainMesh } from './chain_mesh';
import { Environment } from './environment';
import { Equipment, groundBelow } from './equipment';
import { Ground } from './ground';
import { Labels } from './labels';
import type { Beside } from '../states/beside';
import { axisOf, type Model } from '../states/model';
import type { Now } from '../states/now';
import { PALETTES } from './palette';
import { size, type Vec3 } from '../states/path';
import { lineAt, pointAt, project, type Screen, screenOf } from './pick';
import { RollersMesh } from './rollers_mesh';
import type { Scale } from '../states/scale';
import { sharedUniforms } from './shaders';
import { Stage } from './stage';

/** Left to itself the cable is drawn this many pixels thick where the camera looks at, but at most this many times too thick. */
const THICK_PX = 5;
const LARGEST_FACTOR = 100;
/** Marks on the cable are at least this far apart, px. */
const MARKS_PX = 55;
const MARKS_M = [1, 2, 5, 10, 20, 50, 100, 200, 500];
/** The route's shadow on the ground is shown from this distance on, in sizes of the scene: nearer it is only a line somewhere. */
const SHADOW_FROM = 0.5;
/** How near the pointer has to be, px. */
const ROLLER_PX = 9;
const LINE_PX = 12;

export class World {
  readonly stage: Stage;
  readonly labels = new Labels();
  /** The chain that is shown, and those that are pulled together with it. */
  private readonly chains: (ChainMesh | null)[];
  readonly rollers: RollersMesh | null;
  readonly ground: Ground;
  readonly environment: Environment | null;
  private readonly shared = sharedUniforms();
  private readonly equipment: Equipment;
  private readonly routePoints: Float32Array;
  private readonly routeScreen: Screen;
  private readonly rollerScreen: Screen;
  /** How far the scene reaches, m. */
  private readonly wide: number;
  /** Length in whose round numbers the grid is drawn, m. */
  unit = 1;
  /** Exaggeration that was asked for; null: the view's own. */
  private asked: number | null = null;

  constructor(
    root: HTMLElement,
    readonly model: Model,
    still: boolean,
    private readonly beside: Beside,
  ) {
    this.stage = new Stage(root, this.shared, still);
    root.append(this.labels.root);
    const { run, path, extent } = model;
    const wide = (this.wide = extent.reduce((r, p) => Math.max(r, size(p)), 10));
    const low = groundBelow(extent);
    this.ground = new Ground(low, 6 * wide);
    this.equipment = new Equipment(model, this.shared, low + 1e-3);
    this.chains = [model, ...beside.models].map(({ chain }) => (chain ? new ChainMesh(chain, this.shared) : null));
    const rollers = run.geometry?.rollers ?? [];
    this.rollers = rollers.length > 0 ? new RollersMesh(rollers, model, this.shared) : null;
    const reel = run.geometry?.reel;
    if (reel) {
      this.shared.reel.value.set(...model.at(reel.center_m), reel.radius_m);
      this.shared.reelAxis.value.set(...axisOf(reel.axis));
    }
    const { scene } = this.stage;
    scene.add(this.ground.mesh, this.equipment.group);
    if (this.rollers) scene.add(this.rollers.mesh);
    for (const chain of this.chains) {
      if (!chain) continue;
      chain.mesh.visible = false;
      scene.add(chain.mesh);
    }
    const around = run.environment;
    this.environment = around && around.n_triangles > 0 ? new Environment(around, model, this.shared) : null;
    if (this.environment) scene.add(this.environment.group);
    this.stage.reach(6 * wide);
    this.routePoints = Float32Array.from((path?.points ?? []).flat());
    this.routeScreen = screenOf(path?.points.length ?? 0);
    this.rollerScreen = screenOf(rollers.length);
  }

  get factor(): number {
    return this.shared.factor.value;
  }

  /** Exaggeration; null: as suits the distance. */
  exaggerate(factor: number | null): void {
    this.asked = factor;
    this.stage.invalidate();
  }

  paint(theme: Theme): void {
    const palette = PALETTES[theme];
    this.stage.renderer.setClearColor(palette.ground);
    this.equipment.recolour(palette);
    this.rollers?.recolour(palette.steel);
    this.ground.recolour(palette.grid);
    this.environment?.recolour(palette.environment);
    this.shared.light.value.set(theme === 'dark' ? 0.6 : 0.68, 0.42);
    this.stage.invalidate();
  }

  scale(scale: Scale | null): void {
    for (const chain of this.chains) chain?.scale(scale);
    this.stage.invalidate();
  }

  /** Before a picture: sizes that depend on where the camera stands, and the chain as it is now. */
  update(now: Now | null): void {
    const { stage } = this;
    const pixel = this.shared.pixel.value * stage.distance;
    const thick = Math.min(LARGEST_FACTOR, Math.max(1, (THICK_PX * pixel) / this.model.diameter));
    // cables that touch would be drawn inside each other, and a cable in a tunnel within its walls
    const own = this.beside.models.length > 0 || this.environment ? 1 : thick;
    this.shared.factor.value = this.asked ?? own;
    const { target } = stage.controls;
    this.ground.follow(target.x, target.y, stage.distance, this.unit);
    this.ground.mesh.position.z = this.groundHeight();
    this.equipment.shadow(stage.distance > SHADOW_FROM * this.wide);
    const marks = MARKS_M.find((metres) => metres / pixel > MARKS_PX) ?? 1000;
    for (const chain of this.chains) chain?.marks(marks);
    if (now) this.equipment.turn(now.time);
    if (!now) return;
    [now, ...this.beside.nows].forEach((each, k) => {
      const chain = this.chains[k];
      if (!each || !chain) return;
      chain.update(each.centres, each.values);
      chain.mesh.visible = true;
    });
  }

  /** Below what is near the point that the camera looks at: a tunnel may climb by more than one sees of it. */
  private groundHeight(): number {
    const { target } = this.stage.controls;
    const reach = 2 * this.stage.distance;
    const near = this.model.extent.filter(([x, y]) => Math.hypot(x - target.x, y - target.y) < reach);
    return groundBelow(near.length > 0 ? near : this.model.extent);
  }

  updateLabels(): void {
    this.labels.update(this.stage.clip, this.stage.width, this.stage.height);
  }

  /** Index of the roller under the pointer (CSS pixels from the picture's corner), -1 for none. */
  rollerAt(x: number, y: number): number {
    const rollers = this.rollers;
    if (!rollers) return -1;
    const { stage, factor } = this;
    rollers.place(factor);
    project(rollers.centres, stage.clip.elements, stage.width, stage.height, this.rollerScreen);
    const pixel = this.shared.pixel.value;
    const radius = rollers.drawnRadius(0, factor);
    return pointAt(this.rollerScreen, x, y, (depth) => Math.max(ROLLER_PX, radius / (pixel * depth)));
  }

  /** Place along the route under the pointer, m; null away from it. */
  placeAt(x: number, y: number): number | null {
    const { stage, model } = this;
    if (!model.path) return null;
    project(this.routePoints, stage.clip.elements, stage.width, stage.height, this.routeScreen);
    const thick = (0.5 * model.diameter * this.factor) / (this.shared.pixel.value * stage.distance);
    const found = lineAt(this.routeScreen, x, y, Math.max(LINE_PX, 1.2 * thick));
    if (!found) return null;
    const i = Math.min(model.path.points.length - 2, Math.floor(found.index));
    const { s } = model.path;
    return s[i]! + (found.index - i) * (s[i + 1]! - s[i]!);
  }

  /** Where a point (about the model's centre) is in the picture, CSS pixels. */
  onScreen(point: Vec3): { x: number; y: number } {
    const screen = screenOf(1);
    project(point, this.stage.clip.elements, this.stage.width, this.stage.height, screen);
    return { x: screen.x[0]!, y: screen.y[0]! };
  }

  dispose(): void {
    for (const chain of this.chains) chain?.dispose();
    this.rollers?.dispose();
    this.equipment.dispose();
    this.ground.dispose();
    this.environment?.dispose();
    this.labels.root.remove();
    this.stage.dispose();
  }
}
