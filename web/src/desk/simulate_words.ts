/** Texts of the screen Simulate: English, Chinese, German. */
export const SIMULATE_ROWS: readonly (readonly [english: string, zh: string, de: string])[] = [
  ['Simulate', '仿真', 'Simulieren'],
  ['Simulation', '仿真', 'Simulation'],
  ['Back to the case', '返回算例', 'Zurück zum Fall'],
  ['Start', '开始', 'Start'],
  ['Stop', '停止', 'Anhalten'],
  ['Save the report', '保存报告', 'Bericht sichern'],
  ['Print the report', '打印报告', 'Bericht drucken'],
  ['The run', '仿真过程', 'Der Lauf'],
  ['Simulating {1} %', '仿真中 {1} %', 'Simuliert: {1} %'],
  [
    '{1} segments, {2} s of the pull. The program computes it in about {3}; in the browser it takes one to three times as long.',
    '{1} 个单元，牵引过程 {2} 秒。程序计算约需 {3}；在浏览器中需要一至三倍的时间。',
    '{1} Segmente, {2} s des Zuges. Das Programm rechnet etwa {3}; im Browser dauert es ein- bis dreimal so lange.',
  ],
  [
    '{1} segments, {2} s of the pull. How long it takes is not known before.',
    '{1} 个单元，牵引过程 {2} 秒。事先无法估计计算时间。',
    '{1} Segmente, {2} s des Zuges. Wie lange es dauert, ist vorher nicht bekannt.',
  ],
  ['The engine is starting.', '计算引擎正在启动。', 'Der Rechenkern startet.'],
  ['The cable is coming to rest.', '电缆正在达到静止平衡。', 'Das Kabel kommt zur Ruhe.'],
  ['{1} s of {2} s, {3} at the winch', '第 {1} 秒，共 {2} 秒，牵引机拉力 {3}', '{1} s von {2} s, {3} an der Winde'],
  ['Finer settings, pass {1}:', '更细的设置，第 {1} 遍：', 'Feinere Einstellungen, Durchgang {1}:'],
  [
    'Stopped at {1} s. What was computed until then is below; a run that is stopped has no verdict.',
    '在第 {1} 秒停止。此前的计算结果见下；被停止的仿真没有结论。',
    'Angehalten bei {1} s. Unten steht, was bis dahin gerechnet war; ein angehaltener Lauf hat kein Urteil.',
  ],
  ['By the run: {1}', '仿真结论：{1}', 'Nach dem Lauf: {1}'],
  [
    'The case has changed since this run.',
    '此次仿真之后算例已被修改。',
    'Der Fall ist seit diesem Lauf geändert worden.',
  ],
];
