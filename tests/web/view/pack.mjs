// Packs a field as the program does (docs/formats.md), written apart from what unpacks it in web/src/view/states/packed.ts.
import { deflateSync } from 'node:zlib';

/** SI values [frame][item][component] as base64 text. */
export function pack(values, frames, items, components, step) {
  const q = Int32Array.from(values, (value) => Math.round(value / step));
  const at = (f, i, c) => (f < 0 || i < 0 ? 0 : q[(f * items + i) * components + c]);
  const planes = Buffer.alloc(4 * q.length);
  let k = 0;
  for (let f = 0; f < frames; f++)
    for (let i = 0; i < items; i++)
      for (let c = 0; c < components; c++, k++) {
        const d = (at(f, i, c) - at(f, i - 1, c) - (at(f - 1, i, c) - at(f - 1, i - 1, c))) | 0;
        const zigzag = ((d << 1) ^ (d >> 31)) >>> 0;
        for (let byte = 0; byte < 4; byte++) planes[byte * q.length + k] = (zigzag >>> (8 * byte)) & 255;
      }
  return deflateSync(planes, { level: 9 }).toString('base64');
}

export const FIELDS = {
  position: { components: 3, unit: 'm', step: 0.001 },
  tension: { components: 1, unit: 'N', step: 1 },
  curvature: { components: 1, unit: '1/m', step: 1e-4 },
  sidewall: { components: 1, unit: 'N/m', step: 10 },
  speed: { components: 1, unit: 'm/s', step: 0.001 },
};

/** The states of the format, from fields of SI values. */
export function packStates(time, segments, headAt, values) {
  const packed = {};
  for (const [name, field] of Object.entries(values)) {
    const { components, step } = FIELDS[name];
    packed[name] = pack(field, time.length, segments, components, step);
  }
  const fields = Object.fromEntries(Object.keys(values).map((name) => [name, FIELDS[name]]));
  return {
    frames: time.length,
    segments,
    time_s: [...time],
    head_at_m: headAt,
    fields,
    packed,
  };
}
