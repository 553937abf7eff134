// Work that can wait: drawing what is not to be seen yet. The page is painted first; then comes what is near the window, and the rest
// when nobody waits.

/** How far from the window is near. */
const NEAR = '400px 0px';
/** A page that is never painted (a tab behind others) waits no longer than this, ms. */
const PATIENCE = 1500;

/** Resolves when the browser has painted something of the page. */
const painted = new Promise<void>((resolve) => {
  setTimeout(resolve, PATIENCE);
  if (!PerformanceObserver.supportedEntryTypes.includes('paint')) return;
  new PerformanceObserver(() => resolve()).observe({ type: 'paint', buffered: true });
});

/** Not every browser has idle time to tell of. */
const whenIdle = (work: () => void): void => {
  if ('requestIdleCallback' in window) requestIdleCallback(work, { timeout: PATIENCE });
  else setTimeout(work, 50);
};

const waiting = new Map<Element, () => void>();
const seen = new IntersectionObserver((entries) => entries.forEach((e) => e.isIntersecting && now(e.target)), {
  rootMargin: NEAR,
});
let pumping = false;

function now(element: Element): void {
  const work = waiting.get(element);
  drop(element);
  work?.();
}

function drop(element: Element): void {
  waiting.delete(element);
  seen.unobserve(element);
}

/** The first in the queue, then the rest, each in a piece of idle time of its own. */
function pump(): void {
  const [first] = waiting.keys();
  pumping = first !== undefined;
  if (!first) return;
  now(first);
  whenIdle(pump);
}

/** Does the work once the page is painted: at once when the element is near the window, else in its turn. Returns what takes it back. */
export function later(element: Element, work: () => void): () => void {
  waiting.set(element, work);
  void painted.then(() => {
    if (!waiting.has(element)) return;
    seen.observe(element);
    if (!pumping) {
      pumping = true;
      whenIdle(pump);
    }
  });
  return () => drop(element);
}
