// The licence of a library of npm's, as a comment that minifiers keep because it begins with an exclamation mark.
import { readdirSync, readFileSync } from 'node:fs';

export function licence(name) {
  const folder = `node_modules/${name}`;
  const { version } = JSON.parse(readFileSync(`${folder}/package.json`, 'utf8'));
  const file = readdirSync(folder).find((one) => /^LICENSE(\.md)?$/.test(one));
  return `/*! ${name} ${version}\n\n${readFileSync(`${folder}/${file}`, 'utf8').trim()}\n*/`;
}
