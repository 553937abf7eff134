// Data of made-up runs in the format of the page (docs/formats.md), in which every number is known and every part is there.

const range = (n, f) => Array.from({ length: n }, (_, i) => f(i));

/** Names as nobody should choose them. */
export const HOSTILE = {
  script: '</script><script>globalThis.harmed = true</script>',
  image: '<img src=x onerror="globalThis.harmed=true">',
  quotes: `"it's" \`quoted\` & <b>bold</b> \\ \u2028`,
  rightToLeft: '\u202eabc \u05d0\u05d1\u05d2 \u0627\u0644\u0643\u0627\u0628\u0644',
  long: 'x'.repeat(10000),
  formula: '=1+1,"cell"',
};

const LIMITS = [
  ['pull', 'N', 9000, 18900, '40 m (out)', 'eq. 11, K = 1'],
  ['sidewall', 'N/m', 605, 500, '17.1 m (bend)', 'on rollers'],
  ['roller_peak', 'N', 1900, 5000, 'R19', 'rated 5 kN'],
  ['clearance', 'm', 0.05, 0.00635, 'duct', 'usual'],
].map(([name, unit, value, limit, where, source]) => {
  const margin = name === 'clearance' ? 1 - limit / value : 1 - value / limit;
  return { name, unit, value, limit, margin, ok: margin >= 0, where, source };
});

function series(scale) {
  const time = range(201, (i) => i * 0.1);
  return {
    time_s: time,
    winch_force_N: time.map((t) => scale * (1000 + 400 * t + 50 * Math.sin(3 * t))),
    tail_tension_N: time.map(() => 1000),
    winch_speed_m_per_s: time.map((t) => Math.min(0.1, t / 20)),
    max_tension_N: time.map((t) => scale * (1050 + 400 * t + 50 * Math.sin(3 * t))),
    head_at_m: time.map((t) => 10 + 1.5 * t),
    reference_N: time.map((t, i) => (i < 5 ? null : scale * (1000 + 395 * t))),
    reel_speed_rad_per_s: time.map((t) => 0.05 * t),
    paid_out_m: time.map((t) => 10 + t),
    wound_m: time.map((t) => 90 - t),
    speed_0_m_per_s: time.map((t) => Math.min(0.1, t / 21)),
    belt_force_N: time.map((t) => 900 * Math.min(1, t)),
    belt_slip_m_per_s: time.map(() => -0.01),
    motor_torque_N_m: time.map(() => 6),
    motor_speed_m_per_s: time.map(() => 0.1),
  };
}

function geometry() {
  const s = range(81, (i) => i * 0.5);
  const bend = (x) => (x < 20 ? 0 : Math.min(Math.PI / 2, (x - 20) / 10));
  const position = [];
  let at = [0, 0];
  s.forEach((x, i) => {
    if (i > 0) at = [at[0] + 0.5 * Math.cos(bend(x)), at[1] + 0.5 * Math.sin(bend(x))];
    position.push([at[0], at[1], 0.1 * x]);
  });
  const roller = (i) => ({
    name: `R${i}`,
    s_m: 2 * i,
    kind: 'roller',
    position_m: position[4 * i],
    axis: [0, 1, 0],
    radius_m: 0.06,
    width_m: 0.4,
    rating_N: 5000,
  });
  return {
    origin_m: [0, 0, 0],
    up: [0, 0, 1],
    route: { s_m: s, position_m: position, curvature_per_m: s.map((x) => (x > 20 && x < 35.7 ? 0.1 : 0)) },
    rollers: range(20, roller),
    surfaces: [{ name: 'duct', kind: 'duct', points_m: position.slice(0, 20), diameter_m: 0.2 }],
    conveyors: [{ name: 'belt', from_m: 5, to_m: 7, points_m: position.slice(10, 15) }],
    reel: { center_m: [-2, 0, 1], axis: [0, 1, 0], radius_m: 1.5, width_m: 1 },
    winch: { position_m: position[80], direction: [0, 1, 0] },
    obstacles: [],
  };
}

/** One run; `scale` multiplies its forces, so that two runs differ by a known factor. */
export function run(label = 'first', scale = 1) {
  const stations = range(21, (i) => 2 * i);
  const along = (s) => scale * (3000 + 150 * s);
  const places = range(81, (i) => i * 0.5);
  return {
    label,
    summary: {
      title: 'A sample of a pull',
      case: 'cases/sample.yaml',
      version: '0.2.0',
      outcome: 'finished',
      message: '',
      verdict: 'NOT SAFE: 1 of 4 limits broken: sidewall by 21 % at 17.1 m (bend)',
      sim_time_s: 20,
      wall_time_s: 0.5,
      segments: 144,
      steps: 2000,
      pull_force: {
        steady_mean_N: 8000 * scale,
        peak_N: 9000 * scale,
        steady_ripple_rms_N: 5,
        steady_mean_error: { time_N: 10, mesh_N: 30, friction_N: 0, total_N: 40 },
        peak_error: { time_N: 30, mesh_N: 60, friction_N: 0, total_N: 90 },
      },
      theory: { paper_total_N: null, reference_total_N: 8100 * scale },
      speed: { steady_m_per_s: 0.1, settle_time_s: 2.5 },
      steady_window: { from_s: 12, to_s: 20 },
      events: [
        { time_s: 5, what: 'the winch trips', pull_N: 3000 },
        { time_s: 7.5, what: 'the winch starts again', pull_N: 500 },
      ],
      pull_by_position: range(5, (i) => ({
        head_m: 12 + 5 * i,
        pull_N: 2000 + 1000 * i,
        reference_N: 2010 + 1000 * i,
        error_pct: 0.5,
      })),
      conveyors: [
        {
          name: 'belt',
          from_m: 5,
          to_m: 7,
          grip_N: 900,
          reference_N: 900,
          steady_mean_N: 899.5,
          peak_N: 900,
          belt_m_per_s: 0.11,
          slip_m_per_s: -0.01,
          slipping: 1,
        },
      ],
      motors: [
        {
          name: 'motor',
          at_m: 12,
          limit_N_m: 6,
          reference_N: 60,
          steady_mean_N_m: 6,
          peak_N_m: 6,
          surface_m_per_s: 0.1,
          power_W: 6,
          at_limit: 0,
        },
      ],
      surfaces: [
        {
          name: 'duct',
          kind: 'duct',
          from_m: 0,
          to_m: 9.5,
          clearance_m: 0.05,
          jam_ratio: 3.4,
          steady_normal_N: 300,
          steady_friction_N: 90,
          peak_line_load_N_per_m: 600,
          peak_line_load_error: 60,
          peak_at_m: 8,
        },
      ],
      limits: [
        ...LIMITS.map((limit) => ({
          ...limit,
          ...(limit.name === 'sidewall' ? { remedy: 'a radius of 8.66 m in ‘bend’ would do' } : {}),
        })),
        {
          name: 'rope',
          unit: 'N',
          value: 9000,
          limit: null,
          margin: null,
          ok: null,
          where: '',
          source: 'limits.rope_strength is missing',
        },
      ],
      trust: [
        { name: 'energy', value: 1e-5, allowed: 0.01, unit: '1', holds: true, remedy: '' },
        { name: 'numerical_error', value: 0.005, allowed: 0.02, unit: '1', holds: true, remedy: '' },
      ],
      overload: { trip_N: 12000, rollers: [] },
    },
    stations: {
      name: stations.map((s) => `${s} m`),
      s_m: stations,
      paper_N: stations.map((s) => 2900 + 120 * s),
      reference_N: stations.map(along),
      mean_N: stations.map((s) => 1.01 * along(s)),
      peak_N: stations.map((s) => 1.1 * along(s)),
    },
    rollers: {
      name: range(20, (i) => `R${i}`),
      s_m: range(20, (i) => (i === 3 ? null : 2 * i)),
      initial_N: range(20, () => 100),
      steady_N: range(20, (i) => 90 * i),
      peak_N: range(20, (i) => 100 * i),
      rating_N: range(20, (i) => (i === 4 ? null : 5000)),
    },
    series: series(scale),
    inputs: [
      { key: 'chain.0.length', value: '40 m', origin: 'given', where: 'sample.yaml:4' },
      { key: 'cables.power.mass', value: '14 kg/m', origin: 'catalogue', where: 'NKT' },
      { key: 'cables.power.EI', value: '2 kN m2', origin: 'estimated', where: '0.3 EA d2' },
      { key: 'gravity', value: '9.81 m/s2', origin: 'default', where: '' },
    ],
    theory_along: {
      s_m: places,
      forward_N: places.map(along),
      backward_N: places.map((s) => along(40 - s)),
      paper_N: places.map((s) => 2900 + 120 * s),
      forward_sidewall_N_per_m: places.map((s) => (s > 20 && s < 35.7 ? 0.1 * along(s) : 0)),
    },
    geometry: geometry(),
    chain: null,
    envelope: {
      place: {
        s_m: places,
        tension_min_N: places.map((s) => 0.5 * along(s)),
        tension_mean_N: places.map(along),
        tension_max_N: places.map((s) => 1.1 * along(s)),
        sidewall_max_N_per_m: places.map((s) => (s > 20 && s < 35.7 ? 0.1 * scale * (600 + 150 * s) : 20)),
        curvature_max_per_m: places.map((s) => (s > 20 && s < 35.7 ? 0.102 : 0.001)),
      },
    },
    states: null,
  };
}

export const report = (...runs) => ({ format: 1, hawser: '0.2.0', runs });
