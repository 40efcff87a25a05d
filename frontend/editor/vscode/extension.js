// The client: starts `rungproof lsp` and shows networks as drawings. Everything else is the server's.
'use strict';

const vscode = require('vscode');
const { LanguageClient, TransportKind } = require('vscode-languageclient/node');
const { programFor } = require('./program');

let client;
let folder;

async function start() {
  const settings = vscode.workspace.getConfiguration('rungproof');
  const run = {
    command: programFor(settings.get('path'), folder),
    args: ['lsp', ...settings.get('arguments')],
    transport: TransportKind.stdio,
  };
  client = new LanguageClient('rungproof', 'rungproof', { run, debug: run }, {
    documentSelector: ['s7-200-stl', 'iec-61131-3-st', 's7-300-scl', 'rungproof-properties'].map((language) => ({ language })),
    synchronize: {
      fileEvents: vscode.workspace.createFileSystemWatcher('**/{rungproof.toml,*.awl,*.stl,*.st,*.il,*.scl,*.xml,*.prop,*.csv,*.sdf}'),
    },
  });
  try {
    await client.start();
  } catch (error) {
    vscode.window.showErrorMessage(`rungproof does not start: ${error.message}. See the setting rungproof.path.`);
  }
}

async function restart() {
  if (client) await client.stop();
  await start();
}

async function showNetwork() {
  const editor = vscode.window.activeTextEditor;
  if (!editor || !client) return;
  const { line, character } = editor.selection.active;
  try {
    const picture = await client.sendRequest('rungproof/network', {
      textDocument: { uri: editor.document.uri.toString() },
      position: { line, character },
    });
    const panel = vscode.window.createWebviewPanel('rungproof', picture.heading, vscode.ViewColumn.Beside, {});
    panel.webview.html = '<!DOCTYPE html><html><head><meta charset="utf-8">' +
      '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; style-src \'unsafe-inline\'">' +
      `</head><body style="background:white">${picture.svg}</body></html>`;
  } catch (error) {
    vscode.window.showInformationMessage(error.message);
  }
}

async function activate(context) {
  folder = context.extensionPath;
  context.subscriptions.push(
    vscode.commands.registerCommand('rungproof.showNetwork', showNetwork),
    vscode.commands.registerCommand('rungproof.restart', restart),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration('rungproof')) restart();
    }));
  await start();
}

function deactivate() {
  return client ? client.stop() : undefined;
}

module.exports = { activate, deactivate };
