// Which program the extension starts: the one of the setting; else the one inside the extension; else that of the search path.
'use strict';

const fs = require('fs');
const { join } = require('path');

/// `setting` is that of rungproof.path, `folder` that of the extension; `platform` and `arch` as Node.js names them.
function programFor(setting, folder, platform = process.platform, arch = process.arch) {
  if (setting) return setting;
  const inside = join(folder, 'server', `${platform}-${arch}`, platform === 'win32' ? 'rungproof.exe' : 'rungproof');
  if (!fs.existsSync(inside)) return 'rungproof';
  try {
    fs.accessSync(inside, fs.constants.X_OK);
  } catch {
    fs.chmodSync(inside, 0o755);  // some ways of unpacking drop the right to execute
  }
  return inside;
}

module.exports = { programFor };
