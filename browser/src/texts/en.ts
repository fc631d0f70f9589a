// English. Every text of the page has a name here; the other languages must have the same names.
import { enCanvas } from './en.canvas'
import { enShell } from './en.shell'
import { enStrip } from './en.strip'

export const en = { ...enShell, ...enCanvas, ...enStrip }
export type TextKey = keyof typeof en
