// What a person has to do after a fault, as the page calls it: a console's word of steering is a button here.
import { choiceTitle } from './stopText'
import { t } from '../texts/index.svelte'
import { say, type Reason } from '../texts/say'

/** A deed: the name of the button that does it, none where no button does, and what it does or what is to be done. */
export interface Deed {
  readonly button: string
  readonly meaning: string
}

export function deedOf(reason: Reason): Deed {
  const { command, meaning } = reason.args ?? {}
  switch (reason.key) {
    case 'foresight.do_choose':
      return typeof command === 'string' && isReason(meaning)
        ? { button: buttonOf(command), meaning: say(meaning) }
        : { button: '', meaning: say(reason) }
    case 'foresight.do_reset':
      return { button: t('stop.reset'), meaning: t('whatIf.reset') }
    case 'foresight.do_end_frozen':
      return { button: t('stop.endRuntime'), meaning: t('whatIf.endFrozen') }
  }
  return { button: '', meaning: say(reason) }
}

/** `clear flow1` is the button *Try again*, of that flow. */
function buttonOf(command: string): string {
  const [verb = '', flow = ''] = command.split(' ')
  const title = choiceTitle(verb)
  return flow && flow !== 'N' ? t('stopped.ofFlow', { what: title, flow }) : title
}

const isReason = (value: unknown): value is Reason => typeof value === 'object' && value !== null && 'text' in value
