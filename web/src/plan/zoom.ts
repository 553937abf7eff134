// Zoom of a drawing: a box by dragging, a double click or 0 for all, plus and minus, arrows.
import { svg } from '../dom';

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export function bounds(points: [number, number][]): Box {
  const xs = points.map((point) => point[0]);
  const ys = points.map((point) => point[1]);
  const [x, y] = [Math.min(...xs), Math.min(...ys)];
  return { x, y, width: Math.max(...xs) - x, height: Math.max(...ys) - y };
}

/** The box made as wide or as high as the shape of the drawing asks for, about its middle. */
export function shaped(box: Box, ratio: number): Box {
  const width = Math.max(box.width, box.height * ratio);
  const height = width / ratio;
  return { x: box.x + (box.width - width) / 2, y: box.y + (box.height - height) / 2, width, height };
}

export function scaled(box: Box, factor: number): Box {
  const [width, height] = [box.width * factor, box.height * factor];
  return { x: box.x + (box.width - width) / 2, y: box.y + (box.height - height) / 2, width, height };
}

const moved = (box: Box, dx: number, dy: number): Box => ({
  ...box,
  x: box.x + dx * box.width,
  y: box.y + dy * box.height,
});

/** What a key makes of the view; null where it means nothing. */
function byKey(key: string, view: Box, all: Box): Box | null {
  switch (key) {
    case '+':
    case '=':
      return scaled(view, 0.5);
    case '-':
      return view.width * 2 > all.width ? all : scaled(view, 2);
    case '0':
      return all;
    case 'ArrowLeft':
      return moved(view, -0.1, 0);
    case 'ArrowRight':
      return moved(view, 0.1, 0);
    case 'ArrowUp':
      return moved(view, 0, -0.1);
    case 'ArrowDown':
      return moved(view, 0, 0.1);
    default:
      return null;
  }
}

/** The view of a drawing, and what the mouse does to it. `frame` has the keyboard's focus. */
export class Zoom {
  private view: Box;
  private start: [number, number] | null = null;
  private readonly band = svg('rect', {
    class: 'plan-band',
    'vector-effect': 'non-scaling-stroke',
    width: 0,
    height: 0,
  });

  constructor(
    private readonly drawing: SVGSVGElement,
    frame: HTMLElement,
    private readonly all: Box,
    private readonly onView: (view: Box) => void,
    private readonly onPoint: (point: [number, number] | null) => void,
  ) {
    this.view = all;
    drawing.append(this.band);
    drawing.addEventListener('mousedown', (event) => {
      this.start = this.at(event);
      event.preventDefault();
    });
    drawing.addEventListener('mousemove', (event) => this.move(this.at(event)));
    drawing.addEventListener('mouseup', (event) => this.end(this.at(event)));
    drawing.addEventListener('mouseleave', () => {
      this.end(null);
      onPoint(null);
    });
    drawing.addEventListener('dblclick', () => this.show(all));
    frame.addEventListener('keydown', (event) => {
      const box = event.ctrlKey || event.metaKey || event.altKey ? null : byKey(event.key, this.view, all);
      if (!box) return;
      event.preventDefault();
      this.show(box);
    });
    this.show(all);
  }

  show(box: Box): void {
    this.view = box;
    this.drawing.setAttribute('viewBox', `${box.x} ${box.y} ${box.width} ${box.height}`);
    this.onView(box);
  }

  zoomIn(): void {
    this.show(scaled(this.view, 0.5));
  }

  showAll(): void {
    this.show(this.all);
  }

  /** A point of the drawing under the mouse; the drawing may be wider on the page than its view. */
  private at(event: MouseEvent): [number, number] {
    const matrix = this.drawing.getScreenCTM();
    if (!matrix) return [0, 0];
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return [x, y];
  }

  private move(here: [number, number]): void {
    if (this.start) {
      for (const [key, value] of Object.entries(bounds([this.start, here]))) this.band.setAttribute(key, String(value));
    }
    this.onPoint(here);
  }

  private end(here: [number, number] | null): void {
    const box = this.start && here ? bounds([this.start, here]) : null;
    this.start = null;
    this.band.setAttribute('width', '0');
    if (box && Math.max(box.width, box.height) > this.view.width * 0.02) {
      this.show(shaped(box, this.all.width / this.all.height));
    }
  }
}
