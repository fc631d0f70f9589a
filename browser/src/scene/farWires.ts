// Lines from afar, joined to few drawings: some variables together, one outline for all of them that look alike.
import type { LocusView } from '../api.gen'

/** The lines of one variable as a path. */
export interface FarWire {
  readonly svar: string
  readonly d: string
}

/** The lines of some variables that look alike. */
export interface WireOutline {
  readonly look: NonNullable<LocusView['line']>
  d: string
}

/** So many variables share their drawings: where one is dragged, only those of its bundle are drawn anew. */
const TOGETHER = 64

/** The same in bundles that are drawn together, in their order. */
export function bundles<T>(wires: Iterable<T>): T[][] {
  const all = [...wires]
  return Array.from({ length: Math.ceil(all.length / TOGETHER) }, (_, k) => all.slice(k * TOGETHER, (k + 1) * TOGETHER))
}

/** The outlines of these lines by their looks; those of variables that are gone are left out. */
export function wireOutlines(wires: readonly FarWire[], loci: Readonly<Record<string, LocusView>>): WireOutline[] {
  const byLook = new Map<WireOutline['look'], WireOutline>()
  for (const { svar, d } of wires) {
    const locus = loci[svar]
    if (!locus || !d) continue
    const look = locus.line ?? 'idle'
    const outline = byLook.get(look)
    if (outline) outline.d += d
    else byLook.set(look, { look, d })
  }
  return [...byLook.values()]
}
