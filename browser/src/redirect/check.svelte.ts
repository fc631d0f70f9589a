// The look at everything that could keep an application from running; nothing moves (X02).
import { act } from '../act/act'
import { announce } from '../state/announce'
import { pointer } from '../act/refused.svelte'
import { t } from '../texts/index.svelte'

class Check {
  /** The application that is looked at now; empty: none is. */
  under = $state('')

  async look(doc: string): Promise<void> {
    if (this.under || !doc) return
    this.under = doc
    const at = pointer.isStale ? undefined : { x: pointer.x, y: pointer.y }
    try {
      const faults = await act({ t: 'Preflight', doc }, at)
      if (typeof faults === 'number') announce(faults ? t('check.faults', { n: faults }) : t('check.well'))
    } finally {
      this.under = ''
    }
  }
}

export const check = new Check()
