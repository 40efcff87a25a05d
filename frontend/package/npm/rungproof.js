#!/usr/bin/env node
// Starts the program of this platform that lies in the package; its input, output and exit code are those of this
// command.
'use strict';

const { accessSync, chmodSync, constants, existsSync } = require('fs');
const { spawn } = require('child_process');
const { constants: { signals } } = require('os');
const { join } = require('path');

const platform = `${process.platform}-${process.arch}`;
const program = join(__dirname, platform, process.platform === 'win32' ? 'rungproof.exe' : 'rungproof');

function fail(message) {
  process.stderr.write(`error: ${message}\n`);
  process.exit(2);
}

if (!existsSync(program)) {
  fail(`this package has no program for ${platform}\n` +
       `  help: it has programs for ${require('./package.json').rungproof.platforms.join(' and ')}; ` +
       'elsewhere, build rungproof from its sources');
}

// Some package managers drop the right to execute.
try {
  accessSync(program, constants.X_OK);
} catch {
  try {
    chmodSync(program, 0o755);
  } catch (error) {
    fail(`${program} cannot be made executable: ${error.message}`);
  }
}

const child = spawn(program, process.argv.slice(2), { stdio: 'inherit' });
// The terminal sends Ctrl+C to both; the program decides what it means.
process.on('SIGINT', () => {});
for (const signal of ['SIGTERM', 'SIGHUP']) process.on(signal, () => child.kill(signal));
child.on('error', (error) => fail(`${program} does not start: ${error.message}`));
child.on('exit', (code, signal) => process.exit(signal ? 128 + signals[signal] : code));
