// Español: lo que el entorno dice de las grabaciones; véase es.heard.
export const esHeardReview: readonly (readonly [RegExp, string])[] = [
  [
    /^the recording was cut short: what came after its end is not known$/,
    'la grabación quedó cortada: no se sabe qué hubo después de su final',
  ],
  [
    /^(\d+) values were written over before they could be recorded$/,
    '{0} valores se sobrescribieron antes de poder grabarlos',
  ],
  [/^(\d+) events could not be recorded for want of room$/, '{0} sucesos no se pudieron grabar por falta de sitio'],
  [
    /^it was recorded in wall time: continued from an instant, it goes on nearly as then, not exactly$/,
    'se grabó en tiempo real: continuada desde un instante, sigue casi como entonces, no exactamente',
  ],
  [
    /^(.+) cannot be compiled as it is now: the recorded actions are shown without their icons$/,
    '{0} no se puede compilar como está ahora: las acciones grabadas se muestran sin sus iconos',
  ],
  [
    /^(.+) has changed since it was recorded: (\d+) of (\d+) recorded actions ha(?:s|ve) no icon now: (.+)$/,
    '{0} ha cambiado desde que se grabó: {1} de {2} acciones grabadas no tienen icono ahora: {3}',
  ],
  [
    /^(.+) has changed since it was recorded: (\d+) actions? of it now (?:was|were) not there$/,
    '{0} ha cambiado desde que se grabó: {1} de sus acciones de ahora no estaban',
  ],
  [/^(\S+) stood for (\S+)$/, '{0} hizo de {1}'],
  [/^(\S+) stood for (\S+) in flow (\d+)$/, '{0} hizo de {1} en el flujo {2}'],
  [/^everything was stopped: (.+)$/, 'se paró todo: {0}'],
  [/^everything stopped$/, 'se paró todo'],
  [/^the run ended: (.+)$/, 'la ejecución terminó: {=0}'],
  [/^(.+) was lost: (.+)$/, 'se perdió {0}: {1}'],
  [/^(.+) met at (.+)$/, '{0} se encontraron en {1}'],
]
