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
  const notes = jumps.filter((one) => one.blended || one.refused).flatMap(noteLines)
  if (notes.length) return notes
  const limited = jumps.filter((one) => one.limit > 0).sort((a, b) => b.jump / b.limit - a.jump / a.limit)
  const worst = limited[0]
  const lines = worst ? [smoothLine(worst)] : []
  return [...lines, ...jumps.filter((one) => one.limit === 0 && one.jump > 0).map(unknownLine)]
}

function noteLines(one: JumpView): JumpLine[] {
  const params = {
    name: one.variable,
    step: measure(one.jump, one.unit),
    limit: measure(one.limit, one.unit),
    at: seconds(one.at_s),
    n: one.cycles ?? 0,
  }
  const text = t(one.refused ? 'continuity.refused' : 'continuity.blended', params)
  const blended = one.blended ?? 0
  const isMore = one.refused ? blended > 0 : blended > 1
  return [{ text: isMore ? `${text} ${t('continuity.more', { n: blended })}` : text, isNote: true }]
}

function smoothLine(one: JumpView): JumpLine {
  const share = Math.max(1, Math.ceil((100 * one.jump) / one.limit))
  const hint = t('continuity.smoothHint', {
    step: measure(one.jump, one.unit),
    limit: measure(one.limit, one.unit),
    at: seconds(one.at_s),
  })
  return { text: t('continuity.smooth', { name: one.variable, n: share }), hint, isNote: false }
}

function unknownLine(one: JumpView): JumpLine {
  return {
    text: t('continuity.unknown', { name: one.variable, step: measure(one.jump, one.unit), task: one.task }),
    isNote: false,
  }
}

/** A number of three digits that count, with its unit. */
function measure(value: number, unit: string): string {
  const number = new Intl.NumberFormat(look.language, { maximumSignificantDigits: 3, useGrouping: false }).format(value)
  return unit === '-' || !unit ? number : `${number} ${unit}`
}
