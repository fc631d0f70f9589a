// Español.
import type { TextKey } from './en'
import { esCanvas } from './es.canvas'
import { esDictionary } from './es.dictionary'
import { esHelp } from './es.help'
import { esLevels } from './es.levels'
import { esPerform } from './es.perform'
import { esShell } from './es.shell'
import { esStrip } from './es.strip'
import { esUpper } from './es.upper'

export const es: Record<TextKey, string> = { ...esShell, ...esCanvas, ...esStrip, ...esUpper, ...esDictionary, ...esPerform, ...esLevels, ...esHelp }
