// Steps at the switches of a run, in words: what was blended or refused, else how smooth it was.
import type { JumpView } from '../api.gen'
import { look } from '../state/look.svelte'
import { t } from '../texts/index.svelte'
import { seconds } from '../sentences/words'

export interface JumpLine {
  text: string
  hint?: string
  /** Whether something had to be done about it. */
  isNote: boolean
}

export function jumpLines(jumps: readonly JumpView[]): JumpLine[] {
  const notes = jumps.filter((jump) => jump.blended || jump.refused).flatMap(noteLines)
  if (notes.length) return notes
  const limited = jumps.filter((jump) => jump.limit > 0).sort((a, b) => b.jump / b.limit - a.jump / a.limit)
  const worst = limited[0]
  const lines = worst ? [smoothLine(worst)] : []
  return [...lines, ...jumps.filter((jump) => jump.limit === 0 && jump.jump > 0).map(unknownLine)]
}

function noteLines(jump: JumpView): JumpLine[] {
  const params = {
    name: jump.variable,
    step: measure(jump.jump, jump.unit),
    limit: measure(jump.limit, jump.unit),
    at: seconds(jump.at_s),
    n: jump.cycles ?? 0,
  }
  const text = t(jump.refused ? 'continuity.refused' : 'continuity.blended', params)
  const blended = jump.blended ?? 0
  const isMore = jump.refused ? blended > 0 : blended > 1
  return [{ text: isMore ? `${text} ${t('continuity.more', { n: blended })}` : text, isNote: true }]
}

function smoothLine(jump: JumpView): JumpLine {
  const share = Math.max(1, Math.ceil((100 * jump.jump) / jump.limit))
  const hint = t('continuity.smoothHint', {
    step: measure(jump.jump, jump.unit),
    limit: measure(jump.limit, jump.unit),
    at: seconds(jump.at_s),
  })
  return { text: t('continuity.smooth', { name: jump.variable, n: share }), hint, isNote: false }
}

function unknownLine(jump: JumpView): JumpLine {
  return {
    text: t('continuity.unknown', { name: jump.variable, step: measure(jump.jump, jump.unit), task: jump.task }),
    isNote: false,
  }
}

/** A number of three digits that count, with its unit. */
function measure(value: number, unit: string): string {
  const number = new Intl.NumberFormat(look.language, { maximumSignificantDigits: 3, useGrouping: false }).format(value)
  return unit === '-' || !unit ? number : `${number} ${unit}`
}
