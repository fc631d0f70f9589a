// Español: saltos en las entradas de los aparatos cuando cambia lo que los mueve.
import type { enContinuity } from './en.continuity'

export const esContinuity: typeof enContinuity = {
  'continuity.smooth': 'Suave: el mayor salto en un cambio fue el {n} % de lo permitido ({name}).',
  'continuity.smoothHint': '{step} a los {at} s; un ciclo puede cambiarlo en {limit}',
  'continuity.blended':
    '{name} saltó {step} a los {at} s, más que los {limit} de un ciclo. Se repartió en {n} ciclo.|{name} saltó {step} a los {at} s, más que los {limit} de un ciclo. Se repartió en {n} ciclos.',
  'continuity.more': 'En {n} cambio hubo que repartir saltos.|En {n} cambios hubo que repartir saltos.',
  'continuity.refused':
    '{name} habría saltado {step} a los {at} s, demasiado para repartirlo a {limit} por ciclo: el accionamiento se mantuvo.',
  'continuity.unknown': '{name} saltó {step} como mucho; {task} no dice cuánto puede.',
}
