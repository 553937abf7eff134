// Zoom and pan of a drawing: a box by dragging, a double click or 0 for all, plus and minus, arrows.

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The box made at least as wide or high as the shape of the drawing asks for, about its middle. */
export function shaped(box: Box, ratio: number): Box {
  const width = Math.max(box.width, box.height * ratio);
  const height = width / ratio;
  return { x: box.x + (box.width - width) / 2, y: box.y + (box.height - height) / 2, width, height };
}

export function scaled(box: Box, factor: number): Box {
  const [width, height] = [box.width * factor, box.height * factor];
  return { x: box.x + (box.width - width) / 2, y: box.y + (box.height - height) / 2, width, height };
}

export const moved = (box: Box, dx: number, dy: number): Box => ({
  ...box,
  x: box.x + dx * box.width,
  y: box.y + dy * box.height,
});

/** What a key makes of the view; null where it means nothing. */
export function byKey(key: string, view: Box, all: Box): Box | null {
  switch (key) {
    case '+':
    case '=':
      return scaled(view, 0.5);
    case '-':
      return view.width >= all.width ? all : scaled(view, 2);
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
