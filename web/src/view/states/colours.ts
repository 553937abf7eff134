// The colour map: viridis, perceptually uniform and readable with every kind of colour blindness, from 16 colours of it.

const VIRIDIS = [
  0x440154, 0x481a6c, 0x472f7d, 0x414487, 0x39568c, 0x31688e, 0x2a788e, 0x23888e, 0x1f988b, 0x22a884, 0x35b779,
  0x54c568, 0x7ad151, 0xa5db36, 0xd2e21b, 0xfde725,
];

export type Colour = [number, number, number];

/** Red, green and blue, 0 to 255, of a share from 0 to 1; shares outside have the ends' colours. */
export function colourOf(share: number): Colour {
  const last = VIRIDIS.length - 1;
  const at = Math.min(1, Math.max(0, Number.isNaN(share) ? 0 : share)) * last;
  const low = Math.min(last - 1, Math.floor(at));
  const part = at - low;
  const a = VIRIDIS[low]!;
  const b = VIRIDIS[low + 1]!;
  const mix = (shift: number): number => {
    const from = (a >> shift) & 255;
    return from + part * (((b >> shift) & 255) - from);
  };
  return [mix(16), mix(8), mix(0)];
}

/** The map as n pixels of red, green, blue, opacity. */
export function colourRow(n: number): Uint8Array<ArrayBuffer> {
  const row = new Uint8Array(4 * n);
  for (let i = 0; i < n; i++) row.set([...colourOf(i / (n - 1)).map(Math.round), 255], 4 * i);
  return row;
}

/** The map as a CSS gradient. */
export function colourGradient(direction: string): string {
  const stops = VIRIDIS.map((colour) => `#${colour.toString(16).padStart(6, '0')}`);
  return `linear-gradient(${direction}, ${stops.join(', ')})`;
}
