// What stands beside Run of the forecast: a few plain sentences, each with how it is shown.
import type { ForecastView } from '../api.gen'
import { t } from '../texts/index.svelte'
import { say } from '../texts/say'

export interface ForecastLine {
  readonly look: 'plain' | 'dim' | 'mishaps'
  readonly text: string
}

/** The sentences of a forecast; none without one. `isAsAssumed`: whether the workcell stands as at its start. */
export function forecastLines(forecast: ForecastView | undefined, isAsAssumed: boolean): ForecastLine[] {
  if (!forecast?.state || forecast.state === 'none') return []
  if (forecast.state === 'going') return [{ look: 'dim', text: t('forecast.going') }]
  const lines: ForecastLine[] = [{ look: 'plain', text: outlook(forecast) }]
  if (forecast.mishaps) lines.push({ look: 'mishaps', text: t('forecast.mishaps', { n: forecast.mishaps }) })
  else if (forecast.state === 'whole') lines.push(...touches(forecast))
  if (!forecast.worlds?.length && forecast.state === 'whole') return lines
  return [...lines, { look: 'dim', text: t(isAsAssumed ? 'forecast.asAssumed' : 'forecast.otherwise') }]
}

/** That nothing is touched, as far as the worlds say so; nothing of a program without a workcell. */
function touches({ worlds = [], unwatched = [] }: ForecastView): ForecastLine[] {
  const lines: ForecastLine[] = []
  if (worlds.length > unwatched.length) lines.push({ look: 'dim', text: t('forecast.clear') })
  if (unwatched.length) lines.push({ look: 'dim', text: t('forecast.unwatched', { worlds: unwatched.join(', ') }) })
  return lines
}

/** How long it takes and how everything stands then, or why that is not known. */
function outlook({ state, cause, mishaps, lasts_s = 0, standing = [] }: ForecastView): string {
  // Where something happens that is marked at its icon, that says it, and better than what a task said at last.
  const isOverEarly = !cause?.key?.startsWith('desk.forecast_') // those say why nobody looked further
  if (state === 'part' && mishaps && isOverEarly) return t('forecast.stops', { lasts: Number(lasts_s.toFixed(1)) })
  if (state === 'part') return t('forecast.part', { why: say(cause) })
  const lasts = Number(lasts_s.toFixed(1))
  const ends = standing.map((reason) => say(reason)).join(', ')
  return ends ? t('forecast.wholeEnds', { lasts, ends }) : t('forecast.whole', { lasts })
}
