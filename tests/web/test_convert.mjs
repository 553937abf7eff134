// `hawser convert`: a box of 2 x 3 x 4 m in each kind becomes GLB with its area, volume and place; what is wrong is refused.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const hawser = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), 'hawser-convert-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const web = createRequire(fileURLToPath(new URL('../../web/package.json', import.meta.url)));
const { zipSync, strToU8 } = await import(pathToFileURL(web.resolve('three/examples/jsm/libs/fflate.module.js')).href);

// The box, z up, m, from (10, 20, 30); corners counter-clockwise from outside.
const CORNERS = Array.from({ length: 8 }, (_, i) => [10 + 2 * (i & 1), 20 + 3 * ((i >> 1) & 1), 30 + 4 * (i >> 2)]);
const FACES = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
];
const TRIANGLES = FACES.flatMap(([a, b, c, d]) => [
  [a, b, c],
  [a, c, d],
]);

const product = (a, b) =>
  Array.from({ length: 16 }, (_, i) =>
    [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i % 4)] * b[4 * (i >> 2) + k], 0),
  );

/** Area, volume and bounds of a GLB, with its nodes' names and extras; written for this test alone. */
function measure(path) {
  const file = readFileSync(path);
  const length = file.readUInt32LE(12);
  assert.equal(file.toString('latin1', 0, 4), 'glTF');
  assert.equal(file.readUInt32LE(8), file.length);
  const gltf = JSON.parse(file.toString('utf8', 20, 20 + length));
  const numbers = (accessor) => {
    const { bufferView, count, type, componentType } = gltf.accessors[accessor];
    const from = 28 + length + gltf.bufferViews[bufferView].byteOffset;
    const n = count * (type === 'VEC3' ? 3 : 1);
    return Array.from({ length: n }, (_, i) =>
      componentType === 5126 ? file.readFloatLE(from + 4 * i) : file.readUInt32LE(from + 4 * i),
    );
  };
  const found = { area: 0, volume: 0, points: 0, low: [1e9, 1e9, 1e9], high: [-1e9, -1e9, -1e9], nodes: [] };
  const go = (number, above) => {
    const node = gltf.nodes[number];
    const at = product(above, node.matrix ?? [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
    found.nodes.push(node);
    for (const { attributes, indices, mode } of node.mesh === undefined ? [] : gltf.meshes[node.mesh].primitives) {
      const p = numbers(attributes.POSITION);
      const points = [];
      for (let i = 0; i < p.length; i += 3)
        points.push([0, 1, 2].map((k) => at[k] * p[i] + at[4 + k] * p[i + 1] + at[8 + k] * p[i + 2] + at[12 + k]));
      // glTF has y up
      for (const point of points) point.splice(0, 3, point[0], -point[2], point[1]);
      for (const point of points)
        point.forEach((x, k) => {
          found.low[k] = Math.min(found.low[k], x);
          found.high[k] = Math.max(found.high[k], x);
        });
      if (mode === 0) found.points += points.length;
      const corners = mode === 0 ? [] : numbers(indices);
      for (let i = 0; i < corners.length; i += 3) {
        const [a, b, c] = corners.slice(i, i + 3).map((k) => points[k].map((x, j) => x - points[0][j]));
        const u = b.map((x, k) => x - a[k]);
        const v = c.map((x, k) => x - a[k]);
        const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        found.area += 0.5 * Math.hypot(...n);
        found.volume += (a[0] * n[0] + a[1] * n[1] + a[2] * n[2]) / 6;
      }
    }
    for (const child of node.children ?? []) go(child, at);
  };
  go(gltf.scenes[0].nodes[0], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  return found;
}

function convert(name, content, ...options) {
  const path = join(folder, name);
  const to = `${path}.glb`;
  if (content !== null) writeFileSync(path, content);
  const { status, stdout, stderr } = spawnSync(hawser, ['convert', path, '-o', to, ...options], { encoding: 'utf8' });
  return { status, stdout, stderr, to };
}

/** Converts a file that holds the box and measures it; `told`: what the file does not say. */
function box(name, content, ...told) {
  const { status, stdout, stderr, to } = convert(name, content, ...told);
  assert.equal(status, 0, stderr);
  const found = measure(to);
  assert.ok(Math.abs(found.area - 52) < 1e-4, `${name}: area ${found.area}`);
  assert.ok(Math.abs(found.volume - 24) < 1e-4, `${name}: volume ${found.volume}`);
  found.low.forEach((x, k) => assert.ok(Math.abs(x - CORNERS[0][k]) < 1e-5, `${name}: from ${found.low}`));
  found.high.forEach((x, k) => assert.ok(Math.abs(x - CORNERS[7][k]) < 1e-5, `${name}: to ${found.high}`));
  return { ...found, stdout };
}

const rows = (list) => list.map((row) => row.join(' ')).join('\n');
const feet = CORNERS.map((corner) => corner.map((x) => x / 0.3048));
const yUp = CORNERS.map(([x, y, z]) => [x, z, -y]);

test('OBJ, in feet with y up', () => {
  const scaled = yUp.map((corner) => corner.map((x) => x / 0.3048));
  const text = `o tray\nv ${scaled.map((corner) => corner.join(' ')).join('\nv ')}\n${FACES.map((face) => `f ${face.map((i) => `${i + 1}/1/1`).join(' ')}`).join('\n')}\n`;
  const { nodes } = box('box.obj', text, '--unit', 'ft', '--up', 'y');
  assert.ok(nodes.some(({ name }) => name === 'tray'));
});

test('OBJ far from the origin keeps its millimetres; a concave face has its own area', () => {
  const text =
    'v 500000.001 5900000 0\nv 500004.001 5900000 0\nv 500004.001 5900004 0\nv 500002.001 5900001 0\nv 500000.001 5900004 0\nf 1 2 3 4 5\n';
  const { to, stderr } = convert('far.obj', text, '--unit', 'm', '--up', 'z');
  assert.equal(stderr, '');
  const { area, low } = measure(to);
  // a fan from the first corner would have 14 m2; single precision would put the corner on 500000.00
  assert.ok(Math.abs(area - 10) < 1e-5, String(area));
  assert.ok(Math.abs(low[0] - 500000.001) < 1e-5, String(low[0]));
});

test('PLY as text and as bytes in both orders', () => {
  const head = (format, type) =>
    `ply\nformat ${format} 1.0\nelement vertex 8\nproperty ${type} x\nproperty ${type} y\nproperty ${type} z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n`;
  box(
    'text.ply',
    `${head('ascii', 'float')}${rows(feet)}\n${rows(FACES.map((f) => [4, ...f]))}\n`,
    '--unit',
    'ft',
    '--up',
    'z',
  );
  for (const [format, little] of [
    ['binary_little_endian', true],
    ['binary_big_endian', false],
  ]) {
    const data = new DataView(new ArrayBuffer(8 * 24 + 6 * 17));
    CORNERS.flat().forEach((x, i) => data.setFloat64(8 * i, x, little));
    FACES.forEach((face, i) => {
      data.setUint8(192 + 17 * i, 4);
      face.forEach((corner, k) => data.setInt32(193 + 17 * i + 4 * k, corner, little));
    });
    box(
      `${format}.ply`,
      Buffer.concat([Buffer.from(head(format, 'double')), Buffer.from(data.buffer)]),
      '--unit',
      'm',
      '--up',
      'z',
    );
  }
});

test('XYZ: points, with a head', () => {
  const { to, stdout } = convert(
    'cloud.xyz',
    `x y z\n${CORNERS.map((corner) => corner.join('; ')).join('\n')}\n`,
    '--unit',
    'm',
    '--up',
    'z',
  );
  const { points, low, high } = measure(to);
  assert.deepEqual([points, low, high], [8, CORNERS[0], CORNERS[7]]);
  assert.match(stdout, /8 points in 2 nodes/);
});

test('COLLADA, in centimetres with z up, which the file says', () => {
  const text = `<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="24">${rows(CORNERS.map((corner) => corner.map((x) => 100 * x)))}</float_array>
<technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>${TRIANGLES.flat().join(' ')}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="wall"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>`;
  const { nodes } = box('box.dae', text);
  assert.ok(nodes.some(({ name }) => name === 'wall'));
});

test('FBX as text, in metres', () => {
  const ends = FACES.map((face) => [...face.slice(0, 3), -face[3] - 1]).flat();
  const text = `; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXVersion: 7400
}
GlobalSettings:  {
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",2
		P: "UnitScaleFactor", "double", "Number", "",100
	}
}
Objects:  {
	Geometry: 1, "Geometry::g", "Mesh" {
		Vertices: *24 {
			a: ${CORNERS.flat().join(',')}
		}
		PolygonVertexIndex: *24 {
			a: ${ends.join(',')}
		}
	}
	Model: 2, "Model::wall 1", "Mesh" {
		Version: 232
	}
}
Connections:  {
	C: "OO",2,0
	C: "OO",1,2
}
`;
  const { nodes } = box('box.fbx', text);
  assert.ok(
    nodes.some(({ name }) => name === 'wall 1'),
    JSON.stringify(nodes),
  );
});

test('3DS, in millimetres', () => {
  const chunk = (id, ...parts) => {
    const body = Buffer.concat(parts);
    const head = Buffer.alloc(6);
    head.writeUInt16LE(id);
    head.writeUInt32LE(6 + body.length, 2);
    return Buffer.concat([head, body]);
  };
  const words = (...values) => Buffer.from(Uint16Array.from(values).buffer);
  const floats = Buffer.from(Float32Array.from(CORNERS.flat().map((x) => 1000 * x)).buffer);
  const mesh = chunk(
    0x4100,
    chunk(0x4110, words(8), floats),
    chunk(0x4120, words(12, ...TRIANGLES.flatMap((t) => [...t, 7]))),
  );
  const file = chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, Buffer.from('wall\0'), mesh)));
  box('box.3ds', file, '--unit', 'mm', '--up', 'z');
});

test('3MF, whose unit is its own', () => {
  const inches = CORNERS.map((corner) => corner.map((x) => x / 0.0254));
  const model = `<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model" name="wall"><mesh>
<vertices>${inches.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join('')}</vertices>
<triangles>${TRIANGLES.map(([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`).join('')}</triangles></mesh></object></resources><build><item objectid="1"/></build></model>`;
  const rels =
    '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>';
  box('box.3mf', zipSync({ '_rels/.rels': strToU8(rels), '3D/3dmodel.model': strToU8(model) }));
});

/** The box as an extrusion, in millimetres, with a property of its own. */
const ifc = (schema) => `ISO-10303-21;
HEADER;FILE_DESCRIPTION((''),'2;1');FILE_NAME('','',(''),(''),'','','');FILE_SCHEMA(('${schema}'));ENDSEC;
DATA;
#1=IFCCARTESIANPOINT((0.,0.,0.));
#2=IFCAXIS2PLACEMENT3D(#1,$,$);
#3=IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-5,#2,$);
#4=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);
#5=IFCUNITASSIGNMENT((#4));
#6=IFCPROJECT('0000000000000000000001',$,'p',$,$,$,$,(#3),#5);
#7=IFCCARTESIANPOINT((11000.,21500.,30000.));
#8=IFCAXIS2PLACEMENT3D(#7,$,$);
#9=IFCLOCALPLACEMENT($,#8);
#10=IFCRECTANGLEPROFILEDEF(.AREA.,$,$,2000.,3000.);
#11=IFCDIRECTION((0.,0.,1.));
#12=IFCEXTRUDEDAREASOLID(#10,#2,#11,4000.);
#13=IFCSHAPEREPRESENTATION(#3,'Body','SweptSolid',(#12));
#14=IFCPRODUCTDEFINITIONSHAPE($,$,(#13));
#15=IFCBUILDINGELEMENTPROXY('0000000000000000000002',$,'tray 7',$,$,#9,#14,$,$);
#16=IFCPROPERTYSINGLEVALUE('Width',$,IFCLENGTHMEASURE(400.),$);
#17=IFCPROPERTYSET('0000000000000000000003',$,'Pset_Tray',$,(#16));
#18=IFCRELDEFINESBYPROPERTIES('0000000000000000000004',$,$,$,(#15),#17);
ENDSEC;
END-ISO-10303-21;
`;

test('IFC 2x3, 4 and 4x3: names, classes, numbers and properties with units', () => {
  for (const schema of ['IFC2X3', 'IFC4', 'IFC4X3_ADD2']) {
    const { nodes } = box(`${schema}.ifc`, ifc(schema));
    const { extras } = nodes.find(({ extras }) => extras?.guid);
    assert.deepEqual(
      { ...extras, type: extras.type.toUpperCase() },
      {
        id: 15,
        guid: '0000000000000000000002',
        type: 'IFCBUILDINGELEMENTPROXY',
        properties: { Pset_Tray: { Width: { value: 400, unit: 'milli metre' } } },
      },
    );
    assert.ok(nodes.some(({ name }) => name.toUpperCase() === 'IFCBUILDINGELEMENTPROXY'));
    assert.ok(nodes.some(({ name }) => name === 'tray 7'));
  }
});

test('the example tunnel as IFC: its nodes, area, volume and bounds are those of its GLB', () => {
  const script = fileURLToPath(new URL('../../scripts/tunnel_model.py', import.meta.url));
  const path = join(folder, 'tunnel.ifc');
  const { status, stdout } = spawnSync('python3', [script, path], { encoding: 'utf8' });
  assert.equal(status, 0);
  // "walls: 1 of 100 triangles, 3.2 m2, 1.4 m3 each"
  const rows = [...stdout.matchAll(/: (\d+) of \d+ triangles, (\S+) m2, (\S+) m3 each/g)];
  const sum = (k) => rows.reduce((all, row) => all + Number(row[1]) * Number(row[k]), 0);
  const { to, stderr } = convert('tunnel.ifc', null);
  assert.equal(stderr, '');
  const found = measure(to);
  assert.ok(Math.abs(found.area / sum(2) - 1) < 1e-6, `${found.area} of ${sum(2)} m2`);
  assert.ok(Math.abs(found.volume / sum(3) - 1) < 1e-6, `${found.volume} of ${sum(3)} m3`);
  for (const name of ['IfcPipeSegment', 'pipe', 'roller 30', 'tray end'])
    assert.ok(
      found.nodes.some((node) => node.name.toUpperCase() === name.toUpperCase()),
      name,
    );
});

test('what is wrong ends with status 2, says what, and leaves no file', () => {
  const refused = (name, content, pattern, ...options) => {
    const { status, stderr, to } = convert(name, content, ...options);
    assert.equal(status, 2, `${name}: ${stderr}`);
    assert.match(stderr, pattern);
    assert.equal(stderr.trim().split('\n').length, 1);
    assert.ok(!existsSync(to), to);
  };
  refused(
    'a.obj',
    'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
    /does not say its unit \(--unit.* and the axis that points up/,
  );
  refused('a.obj', null, /unit 'yd': one of m, cm, mm, in, ft/, '--unit', 'yd', '--up', 'z');
  refused(
    'b.obj',
    'v 0 0 0\nv 1 0 0\nf 1 2 3\n',
    /line 3: vertex '3' of a face is not among the 2/,
    '--unit',
    'm',
    '--up',
    'z',
  );
  refused('c.obj', 'v 0 x 0\n', /line 1: a vertex has three numbers/, '--unit', 'm', '--up', 'z');
  refused('d.xyz', '0 0 0\n1 2\n', /line 2: not three numbers/, '--unit', 'm', '--up', 'z');
  refused(
    'e.ply',
    'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0\n',
    /end too early/,
    '--unit',
    'm',
    '--up',
    'z',
  );
  refused(
    'f.ifc',
    "ISO-10303-21;\nFILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\n",
    /schema is 'CONFIG_CONTROL_DESIGN'; IFC2X3/,
  );
  refused('g.ifc', 'nothing', /its head does not name a schema/);
  refused('h.dae', '<COLLADA><asset>', /h\.dae: it cannot be read/);
  refused('i.fbx', 'nothing', /Cannot find the version number/);
  refused('j.step', '', /STEP is not read/);
  refused('k.glb', '', /read by a case as it is/);
  refused('l.doc', '', /'\.doc' is not known; known are ifc, obj/);
  refused(
    'm.ifc',
    ifc('IFC4').replace('#12=IFCEXTRUDED', '#12=IFCNOTHING'),
    /no surface and no points.*1 IfcBuildingElementProxy/i,
  );
  refused('n.ifc', ifc('IFC4'), /takes more than 64 MB of memory/, '--memory', '64');
});
