// Español: the page's own texts, and the sentences of reasons.
import type { TextKey } from './en'
import { esCanvas } from './es.canvas'
import { esDictionary } from './es.dictionary'
import { esForesight } from './es.foresight'
import { esHelp } from './es.help'
import { esHolding } from './es.holding'
import { esLevels } from './es.levels'
import { esPerform } from './es.perform'
import { esRecording } from './es.recording'
import { esRedirect } from './es.redirect'
import { esShell } from './es.shell'
import { esStrip } from './es.strip'
import { esTask } from './es.task'
import { esTune } from './es.tune'
import { esUpper } from './es.upper'

export { catalogue as sentences } from './catalogue.es.gen'

export const texts: Record<TextKey, string> = {
  ...esShell,
  ...esCanvas,
  ...esStrip,
  ...esUpper,
  ...esDictionary,
  ...esPerform,
  ...esLevels,
  ...esHelp,
  ...esForesight,
  ...esRedirect,
  ...esHolding,
  ...esRecording,
  ...esTask,
  ...esTune,
}
