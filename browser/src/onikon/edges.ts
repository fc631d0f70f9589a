// The edges of the syntax definition as the page draws them; one that it does not know is flat, and so are all among words.
import { desk } from '../link/desk.svelte'
import { isGrey } from '../geom/palette'
import type { Vertices } from '../geom/jigsaw'
import { isWordsOnly } from './presentation'

const FLAT: Vertices = []

export const lineOf = (edge = ''): Vertices => (isWordsOnly() ? FLAT : (desk.tree.edges[edge]?.[1] ?? FLAT))
/** The neutral one has no colour of its own and follows the ground. */
const isNeutral = (edge: string): boolean => isGrey(desk.tree.edges[edge]?.[0] || '#000000')
export const colourOf = (edge = ''): string =>
  isNeutral(edge) || isWordsOnly() ? 'var(--edge-none)' : desk.tree.edges[edge]![0]

/** A letter for an edge, for those who tell shapes and colours badly: the first of the job that has it. */
export function letterOf(edge = ''): string {
  if (isNeutral(edge) || isWordsOnly()) return '' // it joins everything, or shall not be told
  for (const [name, type] of Object.entries(desk.tree.types))
    if (type.role === 'job' && type.right === edge) return name[0]?.toUpperCase() ?? ''
  return ''
}
