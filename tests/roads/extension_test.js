// node extension_test.js EXTENSION: which program the extension starts, with stand-ins for the editor and its client.
'use strict';

const assert = require('assert');
const fs = require('fs');
const Module = require('module');
const os = require('os');
const path = require('path');

const sources = process.argv[2];
const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'rungproof-extension-'));
process.on('exit', () => fs.rmSync(scratch, { recursive: true }));
for (const file of ['extension.js', 'program.js', 'package.json']) fs.copyFileSync(path.join(sources, file), path.join(scratch, file));
const { programFor } = require(path.join(scratch, 'program.js'));

// Nothing inside: the search path. A setting always wins.
assert.strictEqual(programFor('', scratch, 'linux', 'x64'), 'rungproof');
assert.strictEqual(programFor('/opt/rungproof', scratch, 'linux', 'x64'), '/opt/rungproof');

const inside = path.join(scratch, 'server', 'linux-x64', 'rungproof');
const windows = path.join(scratch, 'server', 'win32-x64', 'rungproof.exe');
for (const file of [inside, windows]) {
  fs.mkdirSync(path.dirname(file), { recursive: true });
  fs.writeFileSync(file, '#!/bin/sh\n', { mode: 0o644 });
}
assert.strictEqual(programFor('', scratch, 'linux', 'x64'), inside);
assert.ok(fs.statSync(inside).mode & 0o100, 'the program inside can be executed');
assert.strictEqual(programFor('', scratch, 'win32', 'x64'), windows);
assert.strictEqual(programFor('mine', scratch, 'linux', 'x64'), 'mine');
assert.strictEqual(programFor('', scratch, 'darwin', 'arm64'), 'rungproof');

// The extension as the editor starts it; its own default for the setting is taken from the manifest.
const manifest = JSON.parse(fs.readFileSync(path.join(scratch, 'package.json'), 'utf8'));
const defaults = manifest.contributes.configuration.properties;
let started;
class LanguageClient {
  constructor(id, name, server) { started = server.run; }
  async start() {}
  async stop() {}
}
const editor = {
  workspace: {
    getConfiguration: () => ({ get: (key) => defaults[`rungproof.${key}`].default }),
    createFileSystemWatcher: () => ({}),
    onDidChangeConfiguration: () => ({}),
  },
  commands: { registerCommand: (name) => { assert.ok(manifest.contributes.commands.some((one) => one.command === name), name); } },
  window: { showErrorMessage: (text) => { throw new Error(text); } },
};
const load = Module._load;
Module._load = (name, ...rest) =>
  name === 'vscode' ? editor : name === 'vscode-languageclient/node' ? { LanguageClient, TransportKind: {} } : load(name, ...rest);
require(path.join(scratch, 'extension.js')).activate({ extensionPath: scratch, subscriptions: [] }).then(() => {
  const expected = process.platform === 'linux' && process.arch === 'x64' ? inside : 'rungproof';
  assert.strictEqual(started.command, expected);
  assert.deepStrictEqual(started.args, ['lsp']);
}).catch((error) => {
  console.error(error);
  process.exit(1);
});
