// The licence of a library of npm's, as a comment that minifiers keep because it begins with an exclamation mark.
import { readFileSync } from 'node:fs';

export function licence(name) {
  const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`, 'utf8'));
  return `/*! ${name} ${version}\n\n${readFileSync(`node_modules/${name}/LICENSE`, 'utf8').trim()}\n*/`;
}
