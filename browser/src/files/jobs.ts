// The job that runs a configuration.
import type { OnikonView } from '../api.gen'

/** The words, else the name, of the job whose configuration lies there; empty: no open dictionary has one. */
export function jobOf(path: string | undefined, onikons: Readonly<Record<string, OnikonView>>): string {
  if (!path) return ''
  const entry = Object.entries(onikons).find(([, onikon]) => onikon.role === 'job' && onikon.source === path)
  return entry ? entry[1].description || entry[0] : ''
}
