// Español.
import type { TextKey } from './en'
import { esCanvas } from './es.canvas'
import { esShell } from './es.shell'
import { esStrip } from './es.strip'

export const es: Record<TextKey, string> = { ...esShell, ...esCanvas, ...esStrip }
