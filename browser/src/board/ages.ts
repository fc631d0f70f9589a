// Ages as people say them: seconds, minutes, hours.
import { t } from '../texts/index.svelte'

export function age(seconds: number): string {
  if (seconds < 5) return t('class.now')
  if (seconds < 60) return t('class.seconds', { count: Math.floor(seconds) })
  const minutes = Math.floor(seconds / 60)
  if (minutes < 60) return t('class.minutes', { count: minutes })
  return t('class.hours', { count: Math.floor(minutes / 60), rest: minutes % 60 })
}

/** How long ago something was. */
export function ago(seconds: number): string {
  return seconds < 5 ? t('class.now') : t('class.ago', { age: age(seconds) })
}
