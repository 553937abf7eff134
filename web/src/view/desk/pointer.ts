// The mouse or a finger on the picture: hover, click, double click.

export interface PointerActions {
  hover(x: number, y: number): void;
  leave(): void;
  click(x: number, y: number): void;
  double(x: number, y: number): void;
}

/** A press that moves farther than this turns the camera and picks nothing, px. */
const STILL_PX = 4;

/** Listens on the picture; positions are CSS pixels from its corner. The function that it returns ends that. */
export function listenToPointer(canvas: HTMLElement, act: PointerActions): () => void {
  let pressed: { x: number; y: number } | null = null;
  let frame = 0;
  let latest: { x: number; y: number } | null = null;
  const position = (event: MouseEvent): { x: number; y: number } => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  // At most once a picture: the pointer reports more often than that.
  const hover = (): void => {
    frame = 0;
    if (latest) act.hover(latest.x, latest.y);
  };
  const listeners: Record<string, (event: PointerEvent & MouseEvent) => void> = {
    pointerdown: (event) => (pressed = position(event)),
    pointermove: (event) => {
      latest = event.buttons === 0 ? position(event) : null;
      frame ||= requestAnimationFrame(hover);
    },
    pointerleave: () => {
      latest = null;
      act.leave();
    },
    click: (event) => {
      const { x, y } = position(event);
      if (pressed && Math.hypot(x - pressed.x, y - pressed.y) < STILL_PX) act.click(x, y);
    },
    dblclick: (event) => {
      const { x, y } = position(event);
      act.double(x, y);
    },
  };
  for (const [name, listener] of Object.entries(listeners)) canvas.addEventListener(name, listener as EventListener);
  return () => {
    cancelAnimationFrame(frame);
    for (const [name, listener] of Object.entries(listeners))
      canvas.removeEventListener(name, listener as EventListener);
  };
}
