// Renderer, camera and controls. A picture is drawn only when something has changed.
import { Matrix4, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { type Pose, poseAt, poseBetween } from './cameras';
import { size, sub, type Vec3 } from '../states/path';
import type { Shared } from './shaders';

/** How long the camera takes to a preset, s. */
const FLIGHT_S = 0.7;
/** Most pixels a CSS pixel. */
const DENSEST = 2;

const vec = (v: Vector3): Vec3 => [v.x, v.y, v.z];

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(35, 1, 0.1, 1000);
  readonly renderer: WebGLRenderer;
  readonly controls: OrbitControls;
  /** Camera's projection times its view, by columns. */
  readonly clip = new Matrix4();
  /** Called before a picture is drawn, with the seconds since the last one; returns whether another has to follow. */
  onFrame: (elapsed: number) => boolean = () => false;
  /** Script time of onFrame and of the renderer's own script with the graphics card's work that it waits for, ms, of the last picture. */
  spent = { update: 0, render: 0 };
  private flight: { from: Pose; to: Pose; part: number } | null = null;
  private request = 0;
  private last = 0;
  private radius = 100;
  private readonly observer: ResizeObserver;

  constructor(
    private readonly root: HTMLElement,
    private readonly shared: Shared,
    private readonly still: boolean,
  ) {
    // Kept after a picture, so that print and screenshots have it.
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(DENSEST, window.devicePixelRatio));
    root.prepend(this.renderer.domElement);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.zoomToCursor = true;
    this.controls.zoomSpeed = 1.6;
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => (this.flight = null));
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(root);
    this.resize();
  }

  get width(): number {
    return Math.max(1, this.root.clientWidth);
  }

  get height(): number {
    return Math.max(1, this.root.clientHeight);
  }

  get aspect(): number {
    return this.width / this.height;
  }

  get pose(): Pose {
    return { position: vec(this.camera.position), target: vec(this.controls.target), fov: this.camera.fov };
  }

  /** Distance from the camera to what it looks at, m. */
  get distance(): number {
    return this.camera.position.distanceTo(this.controls.target);
  }

  private resize(): void {
    this.renderer.setSize(this.width, this.height, false);
    this.camera.aspect = this.aspect;
    this.invalidate();
  }

  /** How far the scene reaches from the origin, m. */
  reach(radius: number): void {
    this.radius = radius;
  }

  /** Flies to a pose, or is there at once. */
  go(to: Pose, atOnce = false): void {
    if (atOnce || this.still) {
      this.flight = null;
      this.stand(to);
    } else this.flight = { from: this.pose, to, part: 0 };
    this.invalidate();
  }

  /** Where the camera stands or flies to. */
  get goal(): Pose {
    return this.flight?.to ?? this.pose;
  }

  zoom(by: number): void {
    const goal = this.goal;
    this.go(poseAt(goal, goal.target, size(sub(goal.position, goal.target)) * by));
  }

  /** Turns round what it looks at, by angles in degrees. */
  orbit(round: number, up: number): void {
    const { position, target, fov } = this.goal;
    const offset = new Vector3(...sub(position, target));
    const level = Math.hypot(offset.x, offset.y);
    const elevation = Math.atan2(offset.z, level) + (up * Math.PI) / 180;
    const azimuth = Math.atan2(offset.y, offset.x) + (round * Math.PI) / 180;
    const distance = offset.length();
    const high = Math.min(1.569, Math.max(-1.569, elevation));
    const flat = distance * Math.cos(high);
    const turned: Vec3 = [flat * Math.cos(azimuth), flat * Math.sin(azimuth), distance * Math.sin(high)];
    this.go({ position: [target[0] + turned[0], target[1] + turned[1], target[2] + turned[2]], target, fov }, true);
  }

  /** Moves camera and target by the same. */
  shift(by: Vec3): void {
    this.camera.position.add(new Vector3(...by));
    this.controls.target.add(new Vector3(...by));
    if (this.flight)
      for (const pose of [this.flight.from, this.flight.to])
        for (const point of [pose.position, pose.target]) point.forEach((x, i) => (point[i] = x + by[i]!));
  }

  private stand(pose: Pose): void {
    this.camera.position.set(...pose.position);
    this.controls.target.set(...pose.target);
    this.camera.fov = pose.fov;
    this.controls.update();
  }

  invalidate(): void {
    this.request ||= requestAnimationFrame((now) => this.frame(now));
  }

  private frame(now: number): void {
    this.request = 0;
    const elapsed = this.last > 0 ? (now - this.last) / 1000 : 0;
    if (this.flight) {
      this.flight.part = Math.min(1, this.flight.part + Math.min(elapsed, 0.1) / FLIGHT_S);
      const { from, to, part } = this.flight;
      this.stand(poseBetween(from, to, part));
      if (part >= 1) this.flight = null;
    }
    const start = performance.now();
    this.fit();
    const more = this.onFrame(elapsed) || this.flight !== null;
    const middle = performance.now();
    this.renderer.render(this.scene, this.camera);
    this.spent = { update: middle - start, render: performance.now() - middle };
    this.last = more ? now : 0;
    if (more) this.invalidate();
  }

  /** The picture as it is now with that many pixels a CSS pixel, as the URL of an image. */
  shot(density: number): string {
    const { renderer } = this;
    const usual = renderer.getPixelRatio();
    renderer.setPixelRatio(density);
    this.fit();
    this.onFrame(0);
    renderer.render(this.scene, this.camera);
    const url = renderer.domElement.toDataURL('image/png');
    renderer.setPixelRatio(usual);
    this.invalidate();
    return url;
  }

  /** Near and far planes about the scene, and the size of a pixel. */
  fit(): void {
    const camera = this.camera;
    const far = camera.position.length() + 1.5 * this.radius + 10;
    camera.near = Math.max(0.02 * this.distance, far * 2e-5, 0.01);
    camera.far = far;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.clip.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.shared.pixel.value = (2 * Math.tan((camera.fov * Math.PI) / 360)) / this.height;
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.observer.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.renderer.domElement.remove();
  }
}
