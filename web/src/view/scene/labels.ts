// Words in the scene: HTML over the picture, so that they are sharp and readable; those of less weight give way.
import type { Matrix4 } from 'three';
import { el } from '../../dom';
import type { Vec3 } from '../states/path';
import { project, type Screen, screenOf } from './pick';

export interface Label {
  text: string;
  point: Vec3;
  /** The heavier is drawn where two overlap; from 100 on always. */
  weight: number;
  kind: string;
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
  weight: number;
}

/** Which boxes are shown: in order of weight those that overlap none shown before; weight 100 and more always. */
export function arranged(boxes: readonly Box[]): boolean[] {
  const order = boxes.map((_, i) => i).sort((a, b) => boxes[b]!.weight - boxes[a]!.weight);
  const kept: Box[] = [];
  const shown = new Array<boolean>(boxes.length).fill(false);
  for (const i of order) {
    const box = boxes[i]!;
    const free = kept.every(
      (other) =>
        Math.abs(box.x - other.x) * 2 >= box.width + other.width ||
        Math.abs(box.y - other.y) * 2 >= box.height + other.height,
    );
    if (!free && box.weight < 100) continue;
    shown[i] = true;
    kept.push(box);
  }
  return shown;
}

/** Width of a letter and height of a line, px, and how far a label stands over its point. */
const LETTER = 6.6;
const LINE = 20;
const ABOVE = 16;

export class Labels {
  readonly root = el('div', { class: 'view-labels', 'aria-hidden': 'true' });
  private elements = new Map<string, { element: HTMLElement; label: Label }>();
  private screen: Screen = screenOf(0);
  private points = new Float32Array(0);

  /** Adds or changes the label of that name; null takes it away. */
  set(name: string, label: Label | null): void {
    const known = this.elements.get(name);
    if (!label) {
      known?.element.remove();
      this.elements.delete(name);
      return;
    }
    if (known && known.label.text === label.text && known.label.kind === label.kind) {
      known.label = label;
      return;
    }
    const element = known?.element ?? el('span');
    element.className = `view-label view-label-${label.kind}`;
    element.replaceChildren(el('b', {}, label.text), el('i'));
    if (!known) this.root.append(element);
    this.elements.set(name, { element, label });
  }

  /** Those that are shown: the words, and where they and their point are in the picture, CSS pixels. */
  shown(): { text: string; x: number; y: number; aside: number }[] {
    return [...this.elements.values()].flatMap(({ element, label }, i) =>
      element.hidden
        ? []
        : [
            {
              text: label.text,
              x: this.screen.x[i]!,
              y: this.screen.y[i]!,
              aside: parseFloat(element.style.getPropertyValue('--aside')) || 0,
            },
          ],
    );
  }

  /** Puts all labels where their points are now. */
  update(clip: Matrix4, width: number, height: number): void {
    const all = [...this.elements.values()];
    if (this.screen.x.length !== all.length) {
      this.screen = screenOf(all.length);
      this.points = new Float32Array(3 * all.length);
    }
    all.forEach(({ label }, i) => this.points.set(label.point, 3 * i));
    project(this.points, clip.elements, width, height, this.screen);
    const { x, y, depth } = this.screen;
    const seen = all.map((_, i) => depth[i]! > 0 && x[i]! > 0 && x[i]! < width && y[i]! > ABOVE && y[i]! < height);
    const shown = arranged(
      all.map(({ label }, i) => ({
        x: seen[i] ? x[i]! : -1e6 * (i + 1),
        y: seen[i] ? y[i]! - ABOVE : 0,
        width: LETTER * label.text.length + 14,
        height: LINE,
        weight: label.weight,
      })),
    );
    all.forEach(({ element }, i) => {
      const visible = seen[i]! && shown[i]!;
      element.hidden = !visible;
      if (!visible) return;
      // Words at the picture's edge move inwards; their point does not.
      const half = 0.5 * (LETTER * all[i]!.label.text.length + 14);
      const inside = Math.min(Math.max(x[i]!, half), width - half);
      element.style.setProperty('--aside', `${(inside - x[i]!).toFixed(0)}px`);
      element.style.transform = `translate(${x[i]!.toFixed(1)}px, ${y[i]!.toFixed(1)}px)`;
    });
  }
}
