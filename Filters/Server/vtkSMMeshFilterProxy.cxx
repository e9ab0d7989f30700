// SPDX-FileCopyrightText: Copyright (c) the Camarón for ParaView authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMMeshFilterProxy.h"

#include "vtkClientServerStream.h"
#include "vtkObjectFactory.h"
#include "vtkSMSession.h"

vtkStandardNewMacro(vtkSMMeshFilterProxy);

namespace
{
//------------------------------------------------------------------------------
// Since the failed update, representations consider themselves modified and would not notify their
// views.
void WakeConsumers(vtkSMProxy* producer)
{
  for (unsigned int i = 0; i < producer->GetNumberOfConsumers(); ++i)
  {
    vtkSMProxy* const consumer = producer->GetConsumerProxy(i);
    if (!consumer || !consumer->GetObjectsCreated() || !consumer->GetSession())
    {
      continue; // deleted, or not yet created
    }
    if (consumer->IsA("vtkSMRepresentationProxy"))
    {
      vtkClientServerStream stream;
      stream << vtkClientServerStream::Invoke << VTKOBJECT(consumer) << "MarkModified"
             << vtkClientServerStream::End;
      consumer->GetSession()->ExecuteStream(consumer->GetLocation(), stream);
      consumer->MarkDirty(producer);
    }
    else if (consumer->IsA("vtkSMSourceProxy"))
    {
      WakeConsumers(consumer);
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkSMMeshFilterProxy::MarkDirty(vtkSMProxy* modifiedProxy)
{
  if (this->NeedsUpdate)
  {
    WakeConsumers(this);
  }
  this->Superclass::MarkDirty(modifiedProxy);
}
