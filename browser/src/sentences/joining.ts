// How the words of a job and of its target join: "turn to" and "above the box" are one sentence, "wait" and "ten" are not.

/** Jobs that end so want their target at once. */
const OPEN_END: Record<string, RegExp> = {
  en: /\b(to|at|for|of|on|onto|in|into|with|by|from|until|through|towards|behind|above|below|over|under)$/i,
  es: /(^|\s)(a|al|en|de|con|por|para|hasta|hacia|sobre|desde|durante|tras)$/i,
}

/** Targets that begin so go on where the words of their job end. */
const GOES_ON: Record<string, RegExp> = {
  en: /^(to|at|for|from|of|on|onto|in|into|above|below|over|under|behind|beside|near|through|until|towards?|with|up|down|back|away|straight|than|once|twice|\S+ times)\b/i,
  es: /^(a|al|en|de|del|desde|hasta|hacia|para|por|con|sobre|encima|debajo|detrás|delante|junto|durante|que|arriba|abajo|atrás|recto|una vez|\S+ veces)([\s,]|$)/i,
}
const LONG = 6 // words; behind so many the time stands better behind a comma

/** Whether the words of a target can follow those of a job at once. */
export function goesOn(language: string, job: string, target: string): boolean {
  if (OPEN_END[language]?.test(job)) return true
  return !job.includes(',') && GOES_ON[language]?.test(target) === true
}

export const isLong = (text: string): boolean => text.includes(',') || text.split(/\s+/).length >= LONG
