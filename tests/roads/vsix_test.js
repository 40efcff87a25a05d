// node vsix_test.js FOLDER VERSION: an unpacked extension: manifests, files that it names, the program inside, and a client that
// is one file: it is loaded with a stand-in for the editor alone.
'use strict';

const assert = require('assert');
const fs = require('fs');
const Module = require('module');
const path = require('path');

const [folder, version] = process.argv.slice(2);
const extension = path.join(folder, 'extension');
const read = (...names) => fs.readFileSync(path.join(folder, ...names), 'utf8');

const manifest = JSON.parse(read('extension', 'package.json'));
assert.strictEqual(manifest.version, version);
const vsix = read('extension.vsixmanifest');
const identity = /<Identity [^>]*Id="rungproof" Version="([^"]*)" Publisher="rungproof" TargetPlatform="([^"]*)"/.exec(vsix);
assert.ok(identity, 'the manifest has no identity with a platform');
assert.strictEqual(identity[1], version);
const platform = identity[2];
assert.match(read('[Content_Types].xml'), /Extension="\.vsixmanifest"/);

const named = [manifest.main, ...manifest.contributes.languages.map((one) => one.configuration),
  ...manifest.contributes.grammars.map((one) => one.path)];
for (const file of named) assert.ok(fs.existsSync(path.join(extension, file)), file);
for (const file of ['readme.md', 'LICENSE.txt', 'NOTICES.txt']) assert.ok(read('extension', file).length > 200, file);
assert.match(read('extension', 'NOTICES.txt'), /=== vscode-languageclient \(npm\)/);
assert.ok(!fs.existsSync(path.join(extension, 'node_modules')), 'the client is not one file');

// One program, that of the platform.
assert.deepStrictEqual(fs.readdirSync(path.join(extension, 'server')), [platform]);
const program = path.join(extension, 'server', platform, platform.startsWith('win32') ? 'rungproof.exe' : 'rungproof');
assert.ok(fs.statSync(program).size > 1e6, 'no program inside');
const head = fs.readFileSync(program).subarray(0, 4).toString('latin1');
assert.ok(platform.startsWith('win32') ? head.startsWith('MZ') : head === '\x7fELF', `${head} is no program of ${platform}`);
if (!platform.startsWith('win32')) assert.ok(fs.statSync(program).mode & 0o111, 'the program cannot be executed');

// What the client asks of the editor while it is loaded is there under any name.
const anything = () => new Proxy(class {}, { get: (target, name) => (name in target ? target[name] : anything()) });
const load = Module._load;
Module._load = (name, ...rest) => {
  if (name === 'vscode') return anything();
  assert.ok(!name.startsWith('vscode-'), `${name} is not in the one file`);
  return load(name, ...rest);
};
const { activate, deactivate } = require(path.join(extension, manifest.main));
assert.strictEqual(typeof activate, 'function');
assert.strictEqual(typeof deactivate, 'function');
console.log(`${platform} ${version}`);
