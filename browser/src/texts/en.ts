// English. Every text of the page has a name here; the other languages must have the same names.
import { enCanvas } from './en.canvas'
import { enDictionary } from './en.dictionary'
import { enForesight } from './en.foresight'
import { enHelp } from './en.help'
import { enHolding } from './en.holding'
import { enLevels } from './en.levels'
import { enPerform } from './en.perform'
import { enRecording } from './en.recording'
import { enRedirect } from './en.redirect'
import { enShell } from './en.shell'
import { enStrip } from './en.strip'
import { enTask } from './en.task'
import { enTune } from './en.tune'
import { enUpper } from './en.upper'

export const en = {
  ...enShell,
  ...enCanvas,
  ...enStrip,
  ...enUpper,
  ...enDictionary,
  ...enPerform,
  ...enLevels,
  ...enHelp,
  ...enForesight,
  ...enRedirect,
  ...enHolding,
  ...enRecording,
  ...enTask,
  ...enTune,
}
export type TextKey = keyof typeof en
